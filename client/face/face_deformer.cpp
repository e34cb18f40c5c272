#include "client/face/face_deformer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <glm/geometric.hpp>

#include "client/face/block_turns.h"
#include "client/face/drawn_blocks.h"
#include "client/face/hair_mover.h"
#include "client/face/head_mover.h"
#include "client/face/muscle_sums.h"
#include "client/face/normal_field.h"
#include "client/face/opposed_channels.h"
#include "client/face/vertex_block.h"
#include "common/check.h"

namespace aucast::face {
namespace {

/// Radians about the x axis and about the y axis.
struct Rotation {
  float pitch = 0;
  float yaw = 0;
  bool operator==(const Rotation&) const = default;
};

/// Something that turns about a point, each vertex by its share: a lid, the jaw, an eye. A joint in
/// the sense of glTF.
struct Mover {
  WeightedBlocks part;
  glm::vec3 hinge{0};
  float forward_per_rad = 0;  ///< it slides forward as it turns down
  std::function<Rotation()> wanted;
  Rotation turn;
};

struct EyeLook {
  glm::vec3 centre{0};
  float head_share = 0;  ///< how much of the head's turn the eye takes part in
  std::size_t mover = 0;
  std::optional<std::size_t> close;
};

struct HeadChannels {
  OpposedChannels turn;
  OpposedChannels pitch;
  OpposedChannels tilt;
  OpposedChannels shift;
};

/// Gathers the blocks in which `weight(vertex)` is not zero everywhere.
template <typename Weight>
WeightedBlocks gather(std::size_t vertex_count, Weight weight) {
  WeightedBlocks result;
  result.all = BlockSet(block_count(vertex_count));
  for (std::size_t block = 0; block < block_count(vertex_count); ++block) {
    Lanes lanes{};
    for (std::size_t i = 0; i < kLanes && block * kLanes + i < vertex_count; ++i) {
      lanes[i] = weight(block * kLanes + i);
    }
    if (lanes == Lanes{}) continue;
    result.blocks.push_back(static_cast<std::uint32_t>(block));
    result.weights.push_back(lanes);
    result.all.insert(block);
  }
  return result;
}

/// Weighted by the triangles' areas; of creases +z.
std::vector<glm::vec3> neutral_normals(const FaceMesh& mesh) {
  std::vector<glm::vec3> normals(mesh.positions.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::vec3 area =
        glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    for (const std::uint32_t corner : {a, b, c}) normals[corner] += area;
  }
  const std::vector<bool> crease = crease_vertices(mesh);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const bool lit = !crease[i] && normals[i] != glm::vec3(0);
    normals[i] = lit ? glm::normalize(normals[i]) : glm::vec3(0, 0, 1);
  }
  return normals;
}

}  // namespace

DeformedFace neutral_face(const Face& face) {
  DeformedFace neutral;
  neutral.positions = face.mesh.positions;
  neutral.normals = neutral_normals(face.mesh);
  for (const Eye& eye : face.eyes) neutral.eye_centres.push_back(eye.centre);
  neutral.eye_forward.assign(face.eyes.size(), {0, 0, 1});
  neutral.eye_open.assign(face.eyes.size(), 1);
  neutral.creases = DrawnBlocks(face).depths();
  return neutral;
}

struct FaceDeformer::State {
  State(const Face& driven, MuscleSums sums, NormalField field);

  State(const State&) = delete;  // movers refer to it
  State& operator=(const State&) = delete;

  void take(std::span<const float> given, const HairSway& sway);
  [[nodiscard]] std::optional<std::size_t> channel(Side side, std::string_view base) const {
    return face.channel_index(sided_name(side, base));
  }
  [[nodiscard]] float value(const std::optional<std::size_t>& channel) const {
    return channel ? activations[*channel] : 0.0F;
  }
  void move(std::span<const float> given, const HairSway& sway);
  void relax_yielding();
  void rest_vanished();
  void add_lids(const Eye& eye);
  void add_jaw();
  void add_eye(const Eye& eye);
  void apply(const Mover& mover);
  void look();
  [[nodiscard]] HeadMover::Pose head_pose() const;

  const Face& face;
  std::vector<float> activations;  ///< clamped
  MuscleSums muscles;
  std::vector<VertexBlock> now;  ///< before the head turns
  BlockSet moved;                ///< the blocks that are elsewhere than the last time
  BlockSet shown;                ///< likewise, with the head's turn
  std::vector<Mover> movers;     ///< in the order in which they turn: lids, jaw, eyes
  std::vector<std::pair<std::size_t, std::size_t>>
      yielding;  ///< a muscle, and the lid it yields to
  std::vector<EyeLook> eyes;
  HeadChannels head_channels;
  DrawnBlocks drawn;
  NormalField normals;
  std::optional<HairMover> hair;
  std::optional<HeadMover> head;
  DeformedFace result;
};

FaceDeformer::State::State(const Face& driven, MuscleSums sums, NormalField field)
    : face(driven),
      activations(driven.channels.size()),
      muscles(std::move(sums)),
      now(muscles.rest()),
      moved(now.size()),
      shown(now.size()),
      drawn(driven),
      normals(std::move(field)) {
  AUCAST_CHECK(face.muscles.size() <= face.channels.size());
  if (face.lids) {
    for (const Eye& eye : face.eyes) add_lids(eye);
  }
  if (face.jaw) add_jaw();
  for (const Eye& eye : face.eyes) add_eye(eye);
  if (face.head) {
    head_channels = {opposed(face, kHeadTurn), opposed(face, kHeadPitch), opposed(face, kHeadTilt),
                     opposed(face, kHeadShift)};
    head.emplace(face);
  }
  if (face.hair) hair.emplace(face);
  result.positions = face.mesh.positions;
  result.normals.assign(face.mesh.positions.size(), {0, 0, 1});
  for (std::size_t block = 0; block < now.size(); ++block) shown.insert(block);
  normals.update(shown, result.normals);
}

/// The map says radians at full closure, positive downwards.
void FaceDeformer::State::add_lids(const Eye& eye) {
  const Side side = side_at(eye.centre.x);
  const auto close = channel(side, "lid_close");
  const auto raise = channel(side, "lid_raise");
  for (std::size_t m = 0; close && m < face.muscles.size(); ++m) {
    if (!face.muscles[m].yields_to_lids || face.channels[m].side != side) continue;
    yielding.emplace_back(m, *close);
  }
  const auto* const map = find_map(face.mesh, "lid_angle");
  const auto angle_here = [&](std::size_t i) {
    const bool left = face.mesh.positions[i].x >= 0;
    const bool mine = side == Side::Both || left == (side == Side::Left);
    return mine ? map_at(map, i, 0) : 0.0F;
  };
  const auto wanted = [this, close, raise] {
    return Rotation{-(value(close) - face.lids->raised(value(raise))), 0};
  };
  movers.push_back({gather(face.mesh.positions.size(), angle_here), eye.centre, 0, wanted, {}});
}

void FaceDeformer::State::add_jaw() {
  const auto* const map = find_map(face.mesh, "jaw");
  const auto weight = [map](std::size_t i) { return map_at(map, i, 0); };
  const auto wanted = [this, jaw = face.channel_index("jaw")] {
    return Rotation{-(value(jaw) * kRadPerDeg * face.jaw->degrees_per_unit), 0};
  };
  movers.push_back({gather(face.mesh.positions.size(), weight),
                    face.jaw->hinge,
                    face.jaw->forward_per_rad,
                    wanted,
                    {}});
}

void FaceDeformer::State::add_eye(const Eye& eye) {
  const Side side = side_at(eye.centre.x);
  const OpposedChannels yaw = opposed(face, kGazeYaw, side);
  const OpposedChannels pitch = opposed(face, kGazePitch, side);
  const auto part = std::find_if(face.mesh.parts.begin(), face.mesh.parts.end(),
                                 [&](const MeshPart& one) { return one.name == eye.part; });
  const bool found = part != face.mesh.parts.end();
  const auto weight = [&](std::size_t i) {
    return found && i >= part->vertex_begin && i - part->vertex_begin < part->vertex_count ? 1.0F
                                                                                           : 0.0F;
  };
  const auto wanted = [this, yaw, pitch, yaw_rad = kRadPerDeg * eye.yaw_deg,
                       pitch_rad = kRadPerDeg * eye.pitch_deg] {
    return Rotation{pitch_rad * pitch.of(activations), yaw_rad * yaw.of(activations)};
  };
  const float head_share =
      found ? map_at(find_map(face.mesh, "head"), part->vertex_begin, 0) : 0.0F;
  const auto close = face.lids ? channel(side, "lid_close") : std::nullopt;
  eyes.push_back({eye.centre, head_share, movers.size(), close});
  movers.push_back({gather(face.mesh.positions.size(), weight), eye.centre, 0, wanted, {}});
}

void FaceDeformer::State::take(std::span<const float> given, const HairSway& sway) {
  AUCAST_CHECK(given.size() == face.channels.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    activations[i] =
        std::isfinite(given[i]) ? std::clamp(given[i], 0.0F, face.channels[i].activation_max) : 0;
  }
  moved.clear();
  relax_yielding();
  muscles.take(activations, moved);
  for (Mover& mover : movers) {
    const Rotation wanted = mover.wanted();
    if (wanted == mover.turn) continue;
    mover.turn = wanted;
    moved |= mover.part.all;
  }
  if (hair) hair->take(sway, moved);
  shown = moved;
  if (head) head->take(head_pose(), shown);
  drawn.take(activations);
  drawn.narrow(moved);
  drawn.narrow(shown);
  muscles.list(moved);
}

void FaceDeformer::State::relax_yielding() {
  for (const auto& [muscle, close] : yielding) {
    // Hardly while a lid only narrows, as it does with 6 and 7.
    activations[muscle] *= 1 - activations[close] * activations[close];
  }
}

/// Brings positions and normals to these activations.
void FaceDeformer::State::move(std::span<const float> given, const HairSway& sway) {
  take(given, sway);
  rest_vanished();
  if (shown.empty()) return;
  moved.for_each([this](std::size_t block) { muscles.at(block, now[block]); });
  for (const Mover& mover : movers) apply(mover);
  if (hair) hair->apply(moved, now);
  const auto show = [this](std::size_t block, const VertexBlock& place) {
    const std::array<Four, kLanes> points = points_of(place);
    normals.place(block, points);
    write_points(points, block_of(result.positions, block));
  };
  if (head && head->turned()) {
    VertexBlock place;
    shown.for_each([&](std::size_t block) {
      head->apply(block, now[block], place);
      show(block, place);
    });
  } else {
    shown.for_each([&](std::size_t block) { show(block, now[block]); });
  }
  normals.update(shown, result.normals);
}

/// Puts creases that are no longer drawn back to their rest places, so that the result does not
/// depend on what was shown before.
void FaceDeformer::State::rest_vanished() {
  drawn.vanished().for_each([this](std::size_t block) {
    write_points(points_of(muscles.rest()[block]), block_of(result.positions, block));
  });
}

void FaceDeformer::State::apply(const Mover& mover) {
  const glm::vec3& hinge = mover.hinge;
  const float forward = mover.forward_per_rad * -mover.turn.pitch;
  for (std::size_t k = 0; mover.turn != Rotation{} && k < mover.part.blocks.size(); ++k) {
    if (!moved.contains(mover.part.blocks[k])) continue;
    VertexBlock& block = now[mover.part.blocks[k]];
    const Lanes& weights = mover.part.weights[k];
    if (mover.turn.pitch != 0) pitch(block, weights, mover.turn.pitch, hinge.y, hinge.z);
    if (mover.turn.yaw != 0) turn(block, weights, mover.turn.yaw, hinge.x, hinge.z);
    if (forward == 0) continue;
    for (std::size_t i = 0; i < kLanes; ++i) block.z[i] += forward * weights[i];
  }
}

HeadMover::Pose FaceDeformer::State::head_pose() const {
  return {head_channels.turn.of(activations), head_channels.pitch.of(activations),
          head_channels.tilt.of(activations), head_channels.shift.of(activations)};
}

/// Where the eyes look.
void FaceDeformer::State::look() {
  result.eye_centres.resize(eyes.size());
  result.eye_forward.resize(eyes.size());
  result.eye_open.resize(eyes.size());
  for (std::size_t e = 0; e < eyes.size(); ++e) {
    const EyeLook& eye = eyes[e];
    const Rotation& gaze = movers[eye.mover].turn;
    VertexBlock ahead;
    set_lane(ahead, 0, {0, 0, 1});
    Lanes wholly{};
    wholly.fill(1);
    pitch(ahead, wholly, gaze.pitch, 0, 0);
    turn(ahead, wholly, gaze.yaw, 0, 0);
    result.eye_open[e] = 1 - value(eye.close);
    result.eye_centres[e] = eye.centre;
    result.eye_forward[e] = {ahead.x[0], ahead.y[0], ahead.z[0]};
    if (head) head->carry(eye.head_share, result.eye_centres[e], result.eye_forward[e]);
    result.eye_forward[e] = glm::normalize(result.eye_forward[e]);
  }
}

FaceDeformer::FaceDeformer(const Face& face)
    : state_(std::make_unique<State>(face, MuscleSums(face), NormalField(face.mesh))) {}
FaceDeformer::FaceDeformer(std::unique_ptr<State> state) : state_(std::move(state)) {}
FaceDeformer::~FaceDeformer() = default;
FaceDeformer::FaceDeformer(FaceDeformer&&) noexcept = default;
FaceDeformer& FaceDeformer::operator=(FaceDeformer&&) noexcept = default;

struct FaceDeformer::Making::Parts {
  explicit Parts(const Face& driven) : face(driven), muscles(driven), normals(driven.mesh) {}

  const Face& face;
  MuscleSums::Making muscles;
  NormalField::Making normals;
  bool has_muscles = false;
};

FaceDeformer::Making::Making(const Face& face) : parts_(std::make_unique<Parts>(face)) {}
FaceDeformer::Making::~Making() = default;

std::optional<FaceDeformer> FaceDeformer::Making::step() {
  Parts& parts = *parts_;
  if (!parts.has_muscles) {
    parts.has_muscles = parts.muscles.step();
    return std::nullopt;
  }
  if (!parts.normals.step()) return std::nullopt;
  return FaceDeformer(
      std::make_unique<State>(parts.face, parts.muscles.finish(), parts.normals.finish()));
}

const DeformedFace& FaceDeformer::deform(std::span<const float> activations, const HairSway& sway) {
  State& state = *state_;
  state.move(activations, sway);
  state.look();
  state.result.creases = state.drawn.depths();
  return state.result;
}

}  // namespace aucast::face
