#include "scripts/facegen/hair.h"

#include "scripts/facegen/distance.h"
#include "scripts/facegen/sculpt.h"
#include "scripts/facegen/weights.h"

namespace aucast::facegen {
namespace {

constexpr Vec3 kInside{0, 3.2, 0.6};
/// Share of a flow line that hangs freely where hair falls behind the ears.
constexpr double kHanging = 0.45;

/// Outside of hair that hangs down behind the ears.
double hanging_distance(const Vec3& p) {
  const Vec3 q{p.x * 0.70, p.y, p.z};
  return round_cone(q, {0, 2.0, -1.5}, {0, -4.2, -1.4}, 3.30, 2.75);
}

/// A haircut over one head. s runs round the hairline in [-12, 12), negative on the right; t along
/// a flow line from the hairline or the tips (0) to the crown (1).
class Growth {
 public:
  explicit Growth(const Identity& who) : cut_(who.hair), head_(head_of(who)) {}

  [[nodiscard]] Vec3 hairline(double s) const {
    Vec3 p = sample<Vec3>(cut_.hairline, std::abs(s));
    if (s < 0) p.x = -p.x;
    return p;
  }

  /// Share of the flow line that hangs freely.
  [[nodiscard]] double hanging(double s) const {
    return cut_.fall > 0 ? kHanging * smooth_step(7.15, 7.95, std::abs(s)) : 0.0;
  }

  /// Angle about the axis through the crown: a coordinate for noise without a seam.
  [[nodiscard]] double azimuth(double s) const {
    const Vec3 axis = glm::normalize(cut_.crown - kInside);
    const Vec3 across = glm::normalize(glm::cross(Vec3{1, 0, 0}, axis));
    const Vec3 other = glm::cross(axis, across);
    const Vec3 d = glm::normalize(hairline(s) - kInside);
    return std::atan2(glm::dot(d, other), glm::dot(d, across));
  }

  /// A ray from inside the head through the place of (s, t).
  struct Ray {
    Vec3 origin{0};
    Vec3 direction{0};
  };
  [[nodiscard]] Ray ray(double s, double t) const {
    const double free = hanging(s);
    const Vec3 from = glm::normalize(hairline(s) - kInside);
    if (t < free) {
      const double way = (free - t) / kHanging;
      return {kInside - Vec3{0, cut_.fall * way, 0.9 * way}, from};
    }
    // On the head: along the sphere towards the crown.
    const Vec3 to = glm::normalize(cut_.crown - kInside);
    const double whole = std::acos(std::clamp(glm::dot(from, to), -1.0, 1.0));
    const double eased = power((t - free) / (1 - free), 1.2);
    return {kInside,
            glm::normalize((from * std::sin((1 - eased) * whole) + to * std::sin(eased * whole)) /
                           std::sin(whole))};
  }

  struct Place {
    Vec3 root{0};  ///< on the skin
    Vec3 direction{0};
    double top = 0;       ///< 0 at the sides, 1 on top
    double parting = 0;   ///< 1 in the parting
    double from_end = 0;  ///< t, faster on hair that hangs: its ends are as short as the hairline
    double edge = 0;      ///< 0 at the hairline, 1 where the hair has its thickness
    double thickness = 0;
  };
  [[nodiscard]] Place place(double s, double t) const {
    const Ray along = ray(s, t);
    Place at;
    at.direction = along.direction;
    at.root = leave(along.origin, along.direction, head_);
    const Vec3 line = hairline(s);
    const double width =
        0.13 + cut_.front_rise * smooth_step(5.5, 7.0, line.y) * smooth_step(3, 5, line.z);
    // The hair lies flat where it is still translucent, or the background shows through at the
    // far temple.
    at.from_end = t * mix(1.0, 2.6, hanging(s) / kHanging);
    at.edge = (1 - power(1 - saturate((at.from_end - 0.075) / width), 2.1)) *
              smooth_step(0.07, 0.13, at.from_end);
    at.top = smooth_step(3.5, 8.0, at.root.y);
    const double from_parting = s - cut_.parting;
    at.parting = bell(from_parting, 0.20 + 0.25 * t) * (1 - smooth_step(0.45, 0.75, t)) * at.top;
    const double long_side = smooth_step(0.15, -2.6, from_parting) * smooth_step(-6.5, -3.0, s) *
                             at.top * smooth_step(2.0, 6.5, at.root.z);
    at.thickness = mix(cut_.side, cut_.top, at.top) + cut_.sweep * long_side * bell(t - 0.20, 0.30);
    at.thickness *= 1 - cut_.parting_depth * at.parting * smooth_step(0.02, 0.14, t);
    at.thickness *= 1 - 0.4 * smooth_step(7, 12, std::abs(s)) * (1 - at.top);
    if (cut_.fall > 0 && std::abs(s) > 6.5) {
      const double root = glm::length(at.root - along.origin);
      const Vec3 outside = leave(along.origin, along.direction, hanging_distance);
      const double hang = glm::dot(outside - along.origin, along.direction) - root;
      // Close to the neck in front, full at the back.
      const double behind = smooth_step(6.9, 9.3, std::abs(s));
      at.thickness = -melt(-at.thickness, -std::max(hang, 0.0) * behind, 0.5);
    }
    return at;
  }

  [[nodiscard]] const Haircut& cut() const { return cut_; }

 private:
  const Haircut& cut_;
  Distance head_;
};

/// Strands as noise about the crown; they sweep away from the parting.
class Strands {
 public:
  Strands(const Growth& growth, double s, double t, double top) : t_(t) {
    const double from_parting = s - growth.cut().parting;
    const double sweep = (from_parting < 0 ? 1.0 : -0.6) *
                         smooth_step(0, 0.2, std::abs(from_parting)) * top * 2.4 * t *
                         (1 - 0.35 * t) * smooth_step(6, 2.5, std::abs(s));
    const double angle = growth.azimuth(s) + sweep * kPi / 12;
    cos_ = std::cos(angle);
    sin_ = std::sin(angle);
  }

  [[nodiscard]] double noise(double round, double along, double shift) const {
    return value_noise({cos_ * round + shift, sin_ * round, t_ * along + shift}) - 0.5;
  }

  /// The ragged hairline: where along the flow line the hair becomes visible.
  [[nodiscard]] double fringe() const {
    return 0.035 *
               (value_noise({cos_ * 95, sin_ * 95, 1}) + value_noise({cos_ * 210, sin_ * 210, 7})) -
           0.012;
  }

 private:
  double t_;
  double cos_ = 1;
  double sin_ = 0;
};

void add_hair_vertex(Part& hair, const Identity& who, const Growth& growth, double s, double t) {
  const Growth::Place at = growth.place(s, t);
  const Strands strands(growth, s, t, at.top);
  const double groove = 1.15 * strands.noise(14, 1.0, 3) + 0.95 * strands.noise(34, 1.4, 17) +
                        0.65 * strands.noise(80, 2.0, 41);
  const double groove_depth = growth.cut().groove * smooth_step(0.02, 0.2, t) *
                              (1 - smooth_step(0.8, 1.0, t)) * (0.55 + 0.45 * at.top);
  const double height = (at.thickness + groove_depth * groove) * at.edge + 0.012;
  const double light = saturate(0.36 + 0.75 * groove + 0.55 * strands.noise(150, 2.5, 7));
  const Vec3 colour = mix(who.colours.hair, who.colours.hair_light, light) *
                      (0.70 + 0.30 * at.edge) * (1 - 0.45 * at.parting);
  // Softly only over the forehead: at the sides and the ends the background would show through.
  const double front = smooth_step(3.8, 2.2, std::abs(s));
  const double visible = at.from_end - mix(1, growth.cut().ragged, front) * strands.fringe();
  hair.add(at.root + at.direction * height, colour,
           smooth_step(0, mix(0.045, growth.cut().softness, front), visible));
}

}  // namespace

Part make_hair(const Identity& who) {
  const Growth growth(who);
  Part hair;
  hair.name = "hair";
  hair.material = face::Material::Hair;
  std::vector<std::vector<std::uint32_t>> rows(kHairRowLength);
  for (std::size_t i = 0; i < kHairStrands; ++i) {
    const double s = static_cast<double>(i) / kHairStrands * 24 - 12;
    for (std::size_t j = 0; j < kHairRowLength; ++j) {
      const double t = static_cast<double>(j) / (kHairRowLength - 1);
      rows[j].push_back(static_cast<std::uint32_t>(hair.vertices.size()));
      add_hair_vertex(hair, who, growth, s, t);
      hair.vertices.back()[Map::Head] = head_field(hair.vertices.back().position);
    }
  }
  // From the crown to the hairline, so that the translucent fringe is drawn over the hair behind it
  // and not the other way round.
  for (std::size_t j = kHairRowLength - 1; j > 0; --j) hair.add_band(rows[j - 1], rows[j], true);
  return hair;
}

}  // namespace aucast::facegen
