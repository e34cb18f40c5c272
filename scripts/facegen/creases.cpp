#include "scripts/facegen/creases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "scripts/facegen/anatomy.h"
#include "scripts/facegen/palette.h"
#include "scripts/facegen/polyline.h"
#include "scripts/facegen/sculpt.h"

namespace aucast::facegen {
namespace {

/// A line in the front plane by points from one end to the other; the bulge lies to its left.
struct Line {
  std::vector<glm::dvec2> points;
  double half_width = 0.2;
  double depth = 1;          ///< darkening in the middle
  double begin_taper = 0.3;  ///< share of the length over which it starts; 0: at once
  double end_taper = 0.4;    ///< share of the length over which it ends
};

struct Crease {
  std::string_view name;
  std::vector<Line> lines;
};

/// The lines of the left side.
std::vector<Crease> creases() {
  return {
      // Right and left overlap in the middle, each fading where the other is whole. The inner and
      // the outer lines lie on the same curves, so that AU1 and AU2 together draw them across the
      // whole forehead.
      {"crease_forehead_inner",
       {{{{-0.7, 5.03}, {0.3, 5.01}, {1.1, 4.88}, {1.9, 4.91}, {2.5, 4.93}}, 0.30, 0.70, 0.4, 0.6},
        {{{-0.7, 5.52}, {0.3, 5.50}, {1.2, 5.38}, {2.0, 5.42}, {2.7, 5.43}}, 0.35, 0.85, 0.4, 0.6},
        {{{-0.7, 6.01}, {0.2, 6.00}, {0.9, 5.92}, {1.7, 5.95}, {2.4, 5.97}},
         0.32,
         0.66,
         0.4,
         0.6}}},
      {"crease_forehead_outer",
       {{{{0.4, 5.00}, {1.1, 4.88}, {1.9, 4.91}, {2.7, 4.89}, {3.4, 4.68}}, 0.30, 0.70, 0.5, 0.6},
        {{{0.3, 5.50}, {1.2, 5.38}, {2.0, 5.42}, {2.8, 5.40}, {3.4, 5.18}}, 0.35, 0.85, 0.5, 0.6},
        {{{0.4, 5.98}, {0.9, 5.92}, {1.7, 5.95}, {2.5, 5.93}, {3.1, 5.76}}, 0.32, 0.62, 0.5, 0.6}}},
      // They bulge towards the brows: with the bulge between them they are a pillar.
      {"crease_glabella",
       {{{{0.46, 4.40}, {0.42, 4.14}, {0.43, 3.84}, {0.53, 3.50}}, 0.20, 1.05, 0.6, 0.45},
        {{{0.10, 4.35}, {0.06, 4.00}, {0.08, 3.70}}, 0.14, 0.35, 0.5, 0.5}}},
      // Fine, and away from the corner of the eye: broad ones beside it are scratches.
      {"crease_crows_feet",
       {{{{3.58, 2.97}, {3.82, 3.15}, {4.04, 3.40}, {4.20, 3.74}}, 0.14, 0.58, 0.6, 0.8},
        {{{3.60, 2.72}, {3.90, 2.75}, {4.20, 2.84}, {4.48, 2.98}}, 0.14, 0.72, 0.6, 0.8},
        {{{3.56, 2.47}, {3.85, 2.35}, {4.12, 2.16}, {4.36, 1.88}}, 0.14, 0.64, 0.6, 0.8}}},
      {"crease_lower_lid",
       {{{{1.20, 2.12}, {1.70, 1.80}, {2.30, 1.70}, {2.95, 1.86}, {3.45, 2.20}},
         0.22,
         0.95,
         0.35,
         0.4}}},
      // Several across the root of the nose and down its sides: a single one is a step.
      {"crease_nose_root",
       {{{{-0.20, 3.32}, {0.10, 3.34}, {0.36, 3.25}, {0.60, 3.06}}, 0.13, 0.85, 0.5, 0.7},
        {{{-0.24, 3.00}, {0.12, 2.98}, {0.46, 2.80}, {0.84, 2.44}}, 0.16, 1.00, 0.5, 0.7},
        {{{-0.16, 2.63}, {0.14, 2.62}, {0.52, 2.40}, {0.94, 1.94}}, 0.16, 1.05, 0.5, 0.7},
        {{{0.22, 2.36}, {0.54, 2.12}, {0.92, 1.72}, {1.18, 1.30}}, 0.18, 1.00, 0.6, 0.7},
        {{{0.40, 1.96}, {0.66, 1.70}, {0.90, 1.36}, {1.06, 1.00}}, 0.17, 0.85, 0.6, 0.7}}},
      {"crease_nasolabial",
       {{{std::vector<glm::dvec2>(kFurrow.rbegin(), kFurrow.rend()), 0.46, 0.95, 0.42, 0.30}}}},
      {"crease_mouth_corner",
       {{{{1.98, -2.84}, {2.11, -2.56}, {2.11, -2.24}, {1.97, -1.94}}, 0.22, 1.0, 0.5, 0.5}}},
      // Across the skin round the red, where the tightened ring of muscle gathers it.
      {"crease_lips",
       {{{{0.44, -1.16}, {0.41, -1.44}, {0.36, -1.74}}, 0.17, 0.34, 0.7, 0.3},
        {{{0.90, -1.24}, {0.83, -1.52}, {0.74, -1.84}}, 0.19, 0.42, 0.7, 0.3},
        {{{1.40, -1.50}, {1.29, -1.74}, {1.16, -2.00}}, 0.18, 0.38, 0.7, 0.3},
        {{{0.50, -3.74}, {0.47, -3.46}, {0.42, -3.16}}, 0.18, 0.34, 0.7, 0.3},
        {{{1.14, -3.44}, {1.04, -3.18}, {0.94, -2.92}}, 0.18, 0.38, 0.7, 0.3}}},
      {"crease_chin",
       {{{{-0.45, -3.42}, {0.45, -3.40}, {1.00, -3.58}, {1.32, -3.95}}, 0.26, 0.95, 0.4, 0.6},
        {{{0.30, -4.10}, {0.42, -4.25}, {0.40, -4.45}}, 0.17, 0.40, 0.5, 0.5},
        {{{0.72, -4.24}, {0.82, -4.39}, {0.80, -4.57}}, 0.16, 0.34, 0.5, 0.5},
        {{{0.10, -4.50}, {0.18, -4.62}, {0.14, -4.80}}, 0.16, 0.36, 0.5, 0.5}}},
      {"crease_neck",
       {{{{1.45, -5.70}, {1.30, -6.50}, {1.12, -7.40}, {0.98, -8.30}}, 0.30, 0.75, 0.4},
        {{{0.50, -5.95}, {0.48, -6.70}, {0.44, -7.50}, {0.40, -8.30}}, 0.24, 0.55, 0.4}}},
  };
}

/// How one person's line on one side differs from the drawn one: no two are the same, and right is
/// never quite left's mirror.
class Hand {
 public:
  Hand(const ExpressionLines& who, int line, int side)
      : who_(who), key_(who.seed * 1009 + line * 31 + (side > 0 ? 0 : 17)) {}

  [[nodiscard]] Line drawn(Line line) const {
    line.half_width *= who_.width;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      // Both sides meet in the middle.
      const double free = smooth_step(0.2, 1.2, std::abs(line.points[i].x));
      const int at = key_ + static_cast<int>(i) * 7;
      const double forehead = smooth_step(4.45, 4.75, line.points[i].y);
      line.points[i] += who_.uneven * mix(0.4, 1.0, forehead) * free *
                        glm::dvec2{0.6 * (hash(at) - 0.5), hash(at + 3) - 0.5};
      line.points[i].y += who_.forehead_up * forehead;
    }
    line.depth *= who_.depth * mix(0.82, 1.0, hash(key_ + 5));
    return line;
  }

  /// Deeper here, shallower there: the share of the depth at `t` of the way.
  [[nodiscard]] double along(double t) const {
    return 1 - 0.45 * value_noise({3.0 * t, 0.37 * key_, 0.5});
  }

 private:
  const ExpressionLines& who_;
  int key_;
};

/// One row across a line: where in half widths, and how dark; -1 is the side of the bulge. A soft
/// core in a wide shade: a fold, not a stroke. Its relief is the renderer's.
struct Across {
  double at = 0;
  double dark = 0;
};
constexpr std::array<Across, 8> kCreaseAcross{{{-2.1, 0},
                                               {-1.15, 0.03},
                                               {-0.65, 0.22},
                                               {-0.25, 0.70},
                                               {0, 1},
                                               {0.4, 0.62},
                                               {1.0, 0.24},
                                               {1.9, 0}}};
/// How much darker the ground of a fold is than its relief makes it.
constexpr double kShade = 0.55;
/// Above the skin: the skin between its vertices is flat, a ribbon is finer.
constexpr double kLift = 0.012;

struct OnSkin {
  Vec3 position{0};
  Vec3 normal{0, 0, 1};
  Maps maps{};
};

/// Puts places of the front plane on the triangles of the skin, with their weights, so that a
/// ribbon goes where the skin goes.
class Draper {
 public:
  explicit Draper(const Skin& skin) : skin_(skin.part) {
    for (const face::Polygon& polygon : skin_.polygons) {
      for (std::size_t k = 2; k < polygon.corner_count; ++k) {
        const std::array<std::uint32_t, 3> t{polygon.corners[0], polygon.corners[k - 1],
                                             polygon.corners[k]};
        // Only what looks to the front can be hit.
        const Vec3 normal = glm::cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0]));
        if (normal.z > 0 && at(t[0]).z > 0.5) triangles_.push_back(t);
      }
    }
  }

  /// The foremost place of the skin at (x, y). Where there is no skin, it is infinitely far away.
  [[nodiscard]] OnSkin drape(const glm::dvec2& p) const {
    OnSkin best;
    best.position.z = -std::numeric_limits<double>::infinity();
    for (const auto& t : triangles_) {
      const glm::dvec2 a{at(t[0])};
      const glm::dvec2 ab = glm::dvec2{at(t[1])} - a;
      const glm::dvec2 ac = glm::dvec2{at(t[2])} - a;
      const glm::dvec2 ap = p - a;
      const double area = ab.x * ac.y - ab.y * ac.x;
      const double v = (ap.x * ac.y - ap.y * ac.x) / area;
      const double w = (ab.x * ap.y - ab.y * ap.x) / area;
      constexpr double kSlack = -1e-9;
      if (!(v >= kSlack && w >= kSlack && v + w <= 1 - kSlack)) continue;
      const Vec3 hit = at(t[0]) * (1 - v - w) + at(t[1]) * v + at(t[2]) * w;
      if (hit.z <= best.position.z) continue;
      best.position = hit;
      best.normal = glm::normalize(glm::cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])));
      for (std::size_t m = 0; m < best.maps.size(); ++m) {
        best.maps[m] = maps(t[0])[m] * (1 - v - w) + maps(t[1])[m] * v + maps(t[2])[m] * w;
      }
    }
    return best;
  }

 private:
  [[nodiscard]] const Vec3& at(std::uint32_t i) const { return skin_.vertices[i].position; }
  [[nodiscard]] const Maps& maps(std::uint32_t i) const { return skin_.vertices[i].maps; }

  const Part& skin_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

/// Into how many pieces a line is cut along its way, the same for every person. Short ones need
/// them for the taper of their ends.
int pieces_of(const Line& line) {
  constexpr double kPiece = 0.30;
  constexpr double kPiecesMin = 6;
  constexpr double kPiecesMax = 14;
  const double length = Polyline(line.points).length();
  return static_cast<int>(std::clamp(std::ceil(length / kPiece), kPiecesMin, kPiecesMax));
}

void add_line(Part& part, const Line& drawn, const Hand& hand, const Draper& draper, int side) {
  const int pieces = pieces_of(drawn);
  const Line line = hand.drawn(drawn);
  const Polyline path(line.points);
  std::vector<std::uint32_t> before;
  for (int i = 0; i <= pieces; ++i) {
    const double t = static_cast<double>(i) / pieces;
    const glm::dvec2 middle = path.along(t);
    const glm::dvec2 way =
        glm::normalize(path.along(std::min(1.0, t + 0.02)) - path.along(std::max(0.0, t - 0.02)));
    const glm::dvec2 to_bulge{-way.y, way.x};
    const double ends = smooth_step(0, line.begin_taper, t) * smooth_step(1, 1 - line.end_taper, t);
    const double depth = line.depth * ends * hand.along(t);
    const double width = line.half_width * (0.55 + 0.45 * ends);
    std::vector<std::uint32_t> row;
    for (const Across& across : kCreaseAcross) {
      const OnSkin on = draper.drape(middle - to_bulge * (across.at * width));
      const Vec3 p = on.position + on.normal * kLift;
      // The light on a forehead ends the range of red: what loses red there looks green.
      const Vec3 colour = mix(kCrease, kForeheadCrease, smooth_step(4.4, 4.9, middle.y));
      row.push_back(part.add({p.x * side, p.y, p.z}, colour, kShade * across.dark * depth));
      Vertex& vertex = part.vertices.back();
      vertex.occlusion = (across.at - kCreaseAcross.front().at) /
                         (kCreaseAcross.back().at - kCreaseAcross.front().at);
      vertex.gloss = depth;
      vertex.maps = on.maps;
    }
    if (i > 0 && side > 0) part.add_band(before, row, false);
    if (i > 0 && side < 0) part.add_band(row, before, false);
    before = std::move(row);
  }
}

}  // namespace

std::vector<Part> make_creases(const Identity& who, const Skin& skin) {
  const Draper draper(skin);
  std::vector<Part> parts;
  int number = 0;
  for (const Crease& crease : creases()) {
    for (const int side : {1, -1}) {
      Part part;
      part.name = std::string(side > 0 ? "left_" : "right_") + std::string(crease.name);
      part.material = face::Material::Crease;
      for (std::size_t i = 0; i < crease.lines.size(); ++i) {
        const Hand hand(who.lines, number + static_cast<int>(i), side);
        add_line(part, crease.lines[i], hand, draper, side);
      }
      parts.push_back(std::move(part));
    }
    number += static_cast<int>(crease.lines.size());
  }
  return parts;
}

}  // namespace aucast::facegen
