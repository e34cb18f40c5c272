#include "scripts/facegen/hair.h"

#include "scripts/facegen/palette.h"
#include "scripts/facegen/sculpt.h"
#include "scripts/facegen/weights.h"

namespace aucast::facegen {
namespace {

constexpr Vec3 kInside{0, 3.2, 0.6};
constexpr Vec3 kCrown{0.9, 9.9, -2.6};
/// Where the parting starts on the hairline.
constexpr double kParting = 2.25;

/// The hairline from the middle of the forehead (0) over temple, sideburn and ear to the nape (12).
constexpr std::array<Key<Vec3>, 18> kHairline{{{0, {0, 7.0, 7.1}},
                                               {0.4, {0.6, 7.02, 7.0}},
                                               {1, {1.4, 7.12, 6.8}},
                                               {2, {2.7, 6.95, 6.0}},
                                               {3, {3.55, 6.1, 5.5}},
                                               {3.8, {4.0, 4.9, 4.9}},
                                               {4.6, {4.35, 3.9, 3.9}},
                                               {5.3, {4.5, 2.3, 3.05}},
                                               {5.8, {4.5, 1.75, 2.55}},
                                               {6.3, {4.6, 2.6, 2.15}},
                                               {7, {4.85, 3.55, 1.3}},
                                               {7.7, {4.8, 3.4, 0.1}},
                                               {8.4, {4.6, 2.0, -0.9}},
                                               {9.2, {4.1, 0.0, -1.6}},
                                               {10.2, {3.0, -1.8, -2.6}},
                                               {11.2, {1.4, -2.5, -3.2}},
                                               {11.6, {0.7, -2.62, -3.35}},
                                               {12, {0, -2.65, -3.4}}}};

/// s in [-12, 12): negative on the right.
Vec3 hairline(double s) {
  Vec3 p = sample<Vec3>(kHairline, std::abs(s));
  if (s < 0) p.x = -p.x;
  return p;
}

/// Angle about the axis through the crown: a coordinate for noise without a seam.
double azimuth(double s) {
  const Vec3 axis = glm::normalize(kCrown - kInside);
  const Vec3 across = glm::normalize(glm::cross(Vec3{1, 0, 0}, axis));
  const Vec3 other = glm::cross(axis, across);
  const Vec3 d = glm::normalize(hairline(s) - kInside);
  return std::atan2(glm::dot(d, other), glm::dot(d, across));
}

/// Direction at t of the way from the hairline (0) to the crown (1), along the sphere.
Vec3 flow_direction(double s, double t) {
  const Vec3 from = glm::normalize(hairline(s) - kInside);
  const Vec3 to = glm::normalize(kCrown - kInside);
  const double whole = std::acos(std::clamp(glm::dot(from, to), -1.0, 1.0));
  const double eased = power(t, 1.2);
  return glm::normalize((from * std::sin((1 - eased) * whole) + to * std::sin(eased * whole)) /
                        std::sin(whole));
}

/// What the place of a vertex on the haircut decides.
struct Cut {
  double top = 0;      ///< 0 at the sides, 1 on top
  double parting = 0;  ///< 1 in the parting
  double edge = 0;     ///< 0 at the hairline, 1 where the hair has its thickness
  double thickness = 0;
};

Cut cut_at(double s, double t, const Vec3& scalp) {
  Cut cut;
  const Vec3 line = hairline(s);
  const double width = 0.13 + 0.10 * smooth_step(5.5, 7.0, line.y) * smooth_step(3, 5, line.z);
  // The hair lies flat where it is still translucent, or the background shows through at the
  // far temple.
  cut.edge = (1 - power(1 - saturate((t - 0.075) / width), 2.1)) * smooth_step(0.07, 0.13, t);
  cut.top = smooth_step(3.5, 8.0, scalp.y);
  const double from_parting = s - kParting;
  cut.parting = bell(from_parting, 0.20 + 0.25 * t) * (1 - smooth_step(0.45, 0.75, t)) * cut.top;
  const double long_side = smooth_step(0.15, -2.6, from_parting) * smooth_step(-6.5, -3.0, s) *
                           cut.top * smooth_step(2.0, 6.5, scalp.z);
  cut.thickness = mix(0.30, 0.72, cut.top) + 0.50 * long_side * bell(t - 0.20, 0.30);
  cut.thickness *= 1 - 0.80 * cut.parting * smooth_step(0.02, 0.14, t);
  cut.thickness *= 1 - 0.4 * smooth_step(7, 12, std::abs(s)) * (1 - cut.top);
  return cut;
}

/// Strands as noise about the crown; they sweep away from the parting.
class Strands {
 public:
  Strands(double s, double t, double top) : t_(t) {
    const double from_parting = s - kParting;
    const double sweep = (from_parting < 0 ? 1.0 : -0.6) *
                         smooth_step(0, 0.2, std::abs(from_parting)) * top * 2.4 * t *
                         (1 - 0.35 * t) * smooth_step(6, 2.5, std::abs(s));
    const double angle = azimuth(s) + sweep * kPi / 12;
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

void add_hair_vertex(Part& hair, double s, double t) {
  const Vec3 direction = flow_direction(s, t);
  const Vec3 scalp = leave(kInside, direction, head_distance);
  const Cut cut = cut_at(s, t, scalp);
  const Strands strands(s, t, cut.top);
  const double groove = 1.15 * strands.noise(14, 1.0, 3) + 0.95 * strands.noise(34, 1.4, 17) +
                        0.65 * strands.noise(80, 2.0, 41);
  const double groove_depth =
      0.16 * smooth_step(0.02, 0.2, t) * (1 - smooth_step(0.8, 1.0, t)) * (0.55 + 0.45 * cut.top);
  const double height = (cut.thickness + groove_depth * groove) * cut.edge + 0.012;
  const double light = saturate(0.36 + 0.75 * groove + 0.55 * strands.noise(150, 2.5, 7));
  const Vec3 colour =
      mix(kHair, kHairLight, light) * (0.70 + 0.30 * cut.edge) * (1 - 0.45 * cut.parting);
  hair.add(scalp + direction * height, colour, smooth_step(0, 0.045, t - strands.fringe()));
}

}  // namespace

Part make_hair() {
  Part hair;
  hair.name = "hair";
  hair.material = face::Material::Hair;
  std::vector<std::vector<std::uint32_t>> rows(kHairRowLength);
  for (std::size_t i = 0; i < kHairStrands; ++i) {
    const double s = static_cast<double>(i) / kHairStrands * 24 - 12;
    for (std::size_t j = 0; j < kHairRowLength; ++j) {
      const double t = static_cast<double>(j) / (kHairRowLength - 1);
      rows[j].push_back(static_cast<std::uint32_t>(hair.vertices.size()));
      add_hair_vertex(hair, s, t);
      hair.vertices.back()[Map::Head] = head_field(hair.vertices.back().position);
    }
  }
  // From the crown to the hairline, so that the translucent fringe is drawn over the hair behind it
  // and not the other way round.
  for (std::size_t j = kHairRowLength - 1; j > 0; --j) hair.add_band(rows[j - 1], rows[j], true);
  return hair;
}

}  // namespace aucast::facegen
