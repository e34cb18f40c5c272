#include "client/app/video/face_diagram.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace aucast::app {
namespace {

using view::Segment;

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kArcSteps = 16;
constexpr int kEllipseSteps = 40;
constexpr float kTagPx = 3;

/// A stroke of a muscle's drawing between two points of the neutral face.
struct Stroke {
  enum class Kind : std::uint8_t {
    Body,        ///< from attachment to insertion
    Attachment,  ///< a dot
    Insertion,   ///< a dot
    Zone,        ///< the border of its zone of influence
    Inner,       ///< where the fall-off begins or the pull is strongest
  };
  std::size_t muscle = 0;
  Kind kind = Kind::Zone;
  std::size_t from = 0;  ///< indices of points
  std::size_t to = 0;
};

/// Collects points and strokes of all muscles.
struct Sketch {
  std::vector<glm::vec3> points;
  std::vector<Stroke> strokes;
  std::size_t current = 0;  ///< the muscle whose strokes are added

  std::size_t point(const glm::vec3& at) {
    points.push_back(at);
    return points.size() - 1;
  }
  void line(Stroke::Kind kind, const glm::vec3& from, const glm::vec3& to) {
    const std::size_t first = point(from);
    strokes.push_back({current, kind, first, point(to)});
  }
  void dot(Stroke::Kind kind, const glm::vec3& at) {
    const std::size_t only = point(at);
    strokes.push_back({current, kind, only, only});
  }
  /// Part of an ellipse about `centre` with these half axes, from `begin` to `end` radians.
  void arc(Stroke::Kind kind, const glm::vec3& centre, const glm::vec3& cos_axis,
           const glm::vec3& sin_axis, float begin, float end, int steps) {
    std::size_t last = 0;
    for (int i = 0; i <= steps; ++i) {
      const float angle = begin + (end - begin) * static_cast<float>(i) / static_cast<float>(steps);
      const std::size_t here =
          point(centre + std::cos(angle) * cos_axis + std::sin(angle) * sin_axis);
      if (i > 0) strokes.push_back({current, kind, last, here});
      last = here;
    }
  }
  void ellipse(Stroke::Kind kind, const glm::vec3& centre, const glm::vec3& cos_axis,
               const glm::vec3& sin_axis) {
    arc(kind, centre, cos_axis, sin_axis, 0, 2 * kPi, kEllipseSteps);
  }
  void body(const glm::vec3& attachment, const glm::vec3& insertion) {
    line(Stroke::Kind::Body, attachment, insertion);
    dot(Stroke::Kind::Attachment, attachment);
    dot(Stroke::Kind::Insertion, insertion);
  }

  void add(const face::LinearMuscle& muscle);
  void add(const face::SheetMuscle& muscle);
  void add(const face::MouthSphincter& muscle);
  void add(const face::EyeSphincter& muscle);
  void add(const face::LocalPull& muscle);
};

/// Across `axis` and the viewer's direction; level for an axis that points at the viewer.
glm::vec3 side_of(const glm::vec3& axis) {
  const glm::vec3 across = glm::cross(axis, glm::vec3(0, 0, 1));
  return glm::length(across) > 1e-6F ? glm::normalize(across) : glm::vec3(1, 0, 0);
}

/// The cone, cut through its axis: the sector of the fall-off with both radii.
void Sketch::add(const face::LinearMuscle& muscle) {
  const glm::vec3 axis = glm::normalize(muscle.insertion - muscle.attachment);
  const glm::vec3 side = side_of(axis);
  for (const float sign : {-1.0F, 1.0F}) {
    const float angle = sign * muscle.zone_rad;
    const glm::vec3 edge = std::cos(angle) * axis + std::sin(angle) * side;
    line(Stroke::Kind::Zone, muscle.attachment, muscle.attachment + muscle.falloff_finish * edge);
  }
  arc(Stroke::Kind::Zone, muscle.attachment, muscle.falloff_finish * axis,
      muscle.falloff_finish * side, -muscle.zone_rad, muscle.zone_rad, kArcSteps);
  if (muscle.falloff_start > 0) {
    arc(Stroke::Kind::Inner, muscle.attachment, muscle.falloff_start * axis,
        muscle.falloff_start * side, -muscle.zone_rad, muscle.zone_rad, kArcSteps);
  }
  body(muscle.attachment, muscle.insertion);
}

/// The strip as a rectangle, with the line on which it moves most.
void Sketch::add(const face::SheetMuscle& muscle) {
  const glm::vec3 way = muscle.insertion - muscle.attachment;
  const glm::vec3 half = side_of(way) * (muscle.width / 2);
  line(Stroke::Kind::Zone, muscle.attachment - half, muscle.attachment + half);
  line(Stroke::Kind::Zone, muscle.insertion - half, muscle.insertion + half);
  line(Stroke::Kind::Zone, muscle.attachment - half, muscle.insertion - half);
  line(Stroke::Kind::Zone, muscle.attachment + half, muscle.insertion + half);
  const glm::vec3 peak = muscle.attachment + muscle.peak * way;
  line(Stroke::Kind::Inner, peak - half, peak + half);
  body(muscle.attachment, muscle.insertion);
}

/// The ellipse; inside the smaller circle the midline stays where it is.
void Sketch::add(const face::MouthSphincter& muscle) {
  const glm::vec3 x{muscle.semi_axes.x, 0, 0};
  const glm::vec3 y{0, muscle.semi_axes.y, 0};
  ellipse(Stroke::Kind::Zone, muscle.centre, x, y);
  ellipse(Stroke::Kind::Inner, muscle.centre, glm::vec3(muscle.semi_axes.y, 0, 0), y);
  dot(Stroke::Kind::Attachment, muscle.centre);
}

/// The ellipse and the axis to which it closes.
void Sketch::add(const face::EyeSphincter& muscle) {
  const glm::vec3 x{muscle.semi_axes.x, 0, 0};
  ellipse(Stroke::Kind::Zone, muscle.centre, x, glm::vec3(0, muscle.semi_axes.y, 0));
  line(Stroke::Kind::Inner, muscle.centre - x, muscle.centre + x);
  dot(Stroke::Kind::Attachment, muscle.centre);
}

/// The ellipse on which exp(-1) is left, and the way of the centre at activation 1.
void Sketch::add(const face::LocalPull& muscle) {
  ellipse(Stroke::Kind::Zone, muscle.centre, glm::vec3(muscle.radii.x, 0, 0),
          glm::vec3(0, muscle.radii.y, 0));
  line(Stroke::Kind::Body, muscle.centre, muscle.centre + muscle.direction);
  dot(Stroke::Kind::Insertion, muscle.centre);
}

Sketch sketch_of(const face::Face& face) {
  Sketch sketch;
  for (const face::Muscle& muscle : face.muscles) {
    std::visit([&](const auto& shape) { sketch.add(shape); }, muscle.shape);
    ++sketch.current;
  }
  return sketch;
}

/// Vertex of the neutral face that is nearest to `point`.
std::size_t nearest_vertex(const face::FaceMesh& mesh, const glm::vec3& point) {
  std::size_t nearest = 0;
  float least = std::numeric_limits<float>::max();
  const std::size_t skin_end =
      mesh.parts.empty() ? mesh.positions.size() : mesh.parts.front().vertex_count;
  for (std::size_t i = 0; i < skin_end; ++i) {
    const glm::vec3 way = mesh.positions[i] - point;
    const float distance = glm::dot(way, way);
    if (distance >= least) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

/// A face whose only vertices are the drawing's points, carried by head and jaw like the bone
/// beneath each muscle's first point: so that the deformer itself says where they go.
face::Face carrier_of(const face::Face& face, const Sketch& sketch) {
  face::Face carrier;
  carrier.mesh.positions = sketch.points;
  carrier.channels = face.channels;
  carrier.jaw = face.jaw;
  carrier.head = face.head;
  const std::vector<float>* jaw = find_map(face.mesh, "jaw");
  std::vector<float>& carried = carrier.mesh.maps["jaw"];
  carried.resize(sketch.points.size());
  std::vector<float> by_muscle(face.muscles.size(), -1);
  for (const Stroke& stroke : sketch.strokes) {
    float& weight = by_muscle[stroke.muscle];
    if (weight < 0) {
      const std::size_t near = nearest_vertex(face.mesh, sketch.points[stroke.from]);
      weight = jaw != nullptr && face.jaw ? (*jaw)[near] : 0.0F;
    }
    carried[stroke.from] = weight;
    carried[stroke.to] = weight;
  }
  carrier.mesh.maps["head"].assign(sketch.points.size(), face.head ? 1.0F : 0.0F);
  return carrier;
}

/// From yellow over orange to red as a muscle works harder.
glm::vec3 active_colour(float share) {
  const glm::vec3 little{1.0F, 0.84F, 0.25F};
  const glm::vec3 much{0.95F, 0.16F, 0.10F};
  return glm::mix(little, much, std::clamp(share, 0.0F, 1.0F));
}

Segment segment_of(const Stroke& stroke, const std::vector<glm::vec3>& points, float share) {
  const bool active = share > 0;
  const glm::vec3 body = active ? active_colour(share) : glm::vec3(0.42F, 0.62F, 0.80F);
  Segment segment{points[stroke.from], points[stroke.to]};
  switch (stroke.kind) {
    case Stroke::Kind::Body:
      segment.colour = glm::vec4(body, 1);
      segment.width_px = active ? 3.5F : 2.0F;
      break;
    case Stroke::Kind::Attachment:
      segment.colour = glm::vec4(body * 0.55F, 1);
      segment.width_px = 6;
      break;
    case Stroke::Kind::Insertion:
      segment.colour = glm::vec4(glm::mix(body, glm::vec3(1), 0.65F), 1);
      segment.width_px = 5;
      break;
    case Stroke::Kind::Zone:
      segment.colour = glm::vec4(body, active ? 0.9F : 0.35F);
      segment.width_px = active ? 1.6F : 1.1F;
      break;
    case Stroke::Kind::Inner:
      segment.colour = glm::vec4(body, active ? 0.6F : 0.22F);
      segment.width_px = 1.1F;
      break;
  }
  return segment;
}

/// From blue (a little) over white to red (all).
glm::vec4 weight_colour(float weight) {
  const glm::vec3 little{0.22F, 0.45F, 0.95F};
  const glm::vec3 middle{0.95F, 0.93F, 0.88F};
  const glm::vec3 all{0.93F, 0.20F, 0.14F};
  const float t = 2 * std::clamp(weight, 0.0F, 1.0F);
  const glm::vec3 colour = t < 1 ? glm::mix(little, middle, t) : glm::mix(middle, all, t - 1);
  return {colour, 1};
}

}  // namespace

struct FaceDiagram::State {
  explicit State(const face::Face& drawn)
      : face(drawn), sketch(sketch_of(drawn)), carrier(carrier_of(drawn, sketch)), mover(carrier) {}

  const face::Face& face;
  Sketch sketch;
  face::Face carrier;
  face::FaceDeformer mover;
  std::vector<Segment> muscles;
  std::vector<Segment> tags;

  void draw_muscles(std::span<const float> activations);
  void tag(const char* map_name, const face::DeformedFace& deformed);
};

/// Muscles at work come last, so that they lie over the others.
void FaceDiagram::State::draw_muscles(std::span<const float> activations) {
  if (sketch.strokes.empty()) return;
  const std::vector<glm::vec3>& points = mover.deform(activations).positions;
  for (const bool working : {false, true}) {
    for (const Stroke& stroke : sketch.strokes) {
      const float activation = activations[stroke.muscle];
      if ((activation > 0) != working) continue;
      const float most = face.channels[stroke.muscle].activation_max;
      muscles.push_back(segment_of(stroke, points, activation / most));
    }
  }
}

void FaceDiagram::State::tag(const char* map_name, const face::DeformedFace& deformed) {
  const std::vector<float>* const weights = find_map(face.mesh, map_name);
  if (weights == nullptr) return;
  float most = 0;
  for (const float weight : *weights) most = std::max(most, std::abs(weight));
  for (const face::MeshPart& part : face.mesh.parts) {
    if (face::is_crease(part)) continue;  // many, on the skin's own
    for (std::size_t i = part.vertex_begin; i < part.vertex_begin + part.vertex_count; ++i) {
      const float weight = std::abs((*weights)[i]);
      if (weight <= 0) continue;
      const glm::vec3 at = deformed.positions[i];
      tags.push_back({at, at, weight_colour(weight / most), kTagPx});
    }
  }
}

FaceDiagram::FaceDiagram(const face::Face& face) : state_(std::make_unique<State>(face)) {}
FaceDiagram::~FaceDiagram() = default;

void FaceDiagram::update(const view::Layers& layers, std::span<const float> activations,
                         const face::DeformedFace& deformed) {
  state_->muscles.clear();
  state_->tags.clear();
  if (layers.muscles) state_->draw_muscles(activations);
  if (layers.jaw_tags) state_->tag("jaw", deformed);
  if (layers.eye_tags) state_->tag("lid_angle", deformed);
}

std::span<const Segment> FaceDiagram::muscles() const {
  return state_->muscles;
}

std::span<const Segment> FaceDiagram::tags() const {
  return state_->tags;
}

}  // namespace aucast::app
