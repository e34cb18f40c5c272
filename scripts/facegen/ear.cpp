#include <span>

#include "scripts/facegen/layout_builder.h"
#include "scripts/facegen/polyline.h"
#include "scripts/facegen/sculpt.h"

namespace aucast::facegen {
namespace {

using Ring = LayoutBuilder::Ring;

// Angles in degrees about the ear: 0 back, 90 up, 180 front, 270 down.

constexpr std::array<Key<double>, 15> kOutline{{{0, 1.42},
                                                {30, 1.64},
                                                {60, 2.02},
                                                {90, 2.20},
                                                {112, 2.02},
                                                {135, 1.42},
                                                {155, 0.98},
                                                {175, 0.76},
                                                {200, 0.72},
                                                {220, 0.84},
                                                {240, 1.28},
                                                {258, 1.76},
                                                {280, 1.94},
                                                {305, 1.76},
                                                {332, 1.48}}};

constexpr std::size_t kAngleCount = 11;
constexpr std::array<double, kAngleCount> kAngles{0,   45,  90,  120, 145, 165,
                                                  185, 205, 230, 270, 315};

/// Each ring's share of the outline's radius at each of kAngles. In front the outer ones lie on the
/// cheek.
constexpr std::array<std::array<double, kAngleCount>, kEarRings> kScale{{
    {.80, .82, .84, .91, 1.06, 1.14, 1.16, 1.14, 1.04, .88, .82},  // behind the ear
    {.96, .96, .96, .97, 1.00, 1.02, 1.03, 1.02, .99, .97, .96},
    {1.0, 1.0, 1.0, .99, .95, .93, .92, .92, .94, 1.0, 1.0},  // the rim
    {.965, .965, .965, .94, .88, .84, .82, .83, .88, .96, .97},
    {.905, .905, .90, .87, .80, .74, .72, .74, .81, .89, .91},
    {.83, .83, .82, .79, .71, .64, .63, .66, .73, .81, .83},
    {.74, .74, .73, .70, .62, .55, .54, .57, .64, .72, .74},
    {.65, .65, .64, .61, .53, .46, .45, .48, .54, .62, .65},
    {.56, .56, .55, .51, .44, .38, .37, .39, .44, .52, .56},
    {.46, .45, .45, .41, .35, .30, .29, .30, .34, .41, .45},
    {.31, .30, .29, .27, .24, .20, .20, .20, .23, .27, .30},
    {.12, .11, .11, .10, .09, .08, .08, .08, .09, .10, .12},
}};

/// Height of the two rings behind the rim over the plate of the ear.
constexpr std::array<std::array<double, kAngleCount>, 2> kBehind{{
    {-.12, -.12, -.10, -.04, .00, .00, .00, .01, .00, -.16, -.16},
    {.16, .16, .14, .10, .05, .03, .02, .04, .05, .00, .06},
}};

// Lines of (back, up, strength).

/// The rim: from its root in the shell forwards, over the top, down the back into the lobe.
constexpr std::array<Vec3, 13> kHelix{{{.16, -.06, .3},
                                       {-.14, .10, .7},
                                       {-.44, .36, .9},
                                       {-.68, .78, 1},
                                       {-.74, 1.25, 1},
                                       {-.52, 1.74, 1},
                                       {-.04, 2.02, 1},
                                       {.50, 1.92, 1},
                                       {.98, 1.48, 1},
                                       {1.27, .80, 1},
                                       {1.33, .10, .95},
                                       {1.20, -.62, .75},
                                       {.95, -1.25, .4}}};
/// Where the inner ridge parts.
constexpr Vec3 kFork{.52, .80, .95};
/// The inner ridge from the antitragus up, and its two legs.
constexpr std::array<Vec3, 6> kAntihelix{
    {{.02, -1.00, .75}, {.36, -.98, .7}, {.66, -.66, .75}, {.80, -.15, 1}, {.74, .36, 1}, kFork}};
constexpr std::array<Vec3, 3> kUpperLeg{{kFork, {.30, 1.20, .75}, {.06, 1.56, .35}}};
constexpr std::array<Vec3, 3> kLowerLeg{{kFork, {.10, .82, .85}, {-.36, .78, .6}}};
constexpr std::array<Vec3, 3> kTragus{{{-.50, -.12, .7}, {-.44, -.36, 1}, {-.42, -.56, .7}}};

/// Height of the front of the ear over its plate.
double relief(double back, double up) {
  const glm::dvec2 at{back, up};
  const double shell =
      glm::length(glm::dvec2{(back - 0.12) / 0.62, (up + 0.22) / (up > -0.22 ? 0.92 : 0.76)});
  const double ridge =
      std::max({Polyline(kAntihelix).strength(at, 0.24), Polyline(kUpperLeg).strength(at, 0.19),
                Polyline(kLowerLeg).strength(at, 0.15)});
  const double lobe = bell(Vec3{(back - 0.2) / 0.7, (up + 1.55) / 0.42, 0});
  const double fork = bell(Vec3{(back - 0.05) / 0.28, (up - 1.14) / 0.26, 0});
  // The furrow behind the inner ridge is shallow below: narrow and deep, its quads would show.
  const double floor = bell(Vec3{(back - 0.98) / 0.26, (up + 0.25) / 0.7, 0});
  return 0.06 - 0.60 * smooth_step(1.02, 0.24, shell) + 0.46 * Polyline(kHelix).strength(at, 0.19) +
         0.43 * ridge - 0.14 * fork + 0.34 * Polyline(kTragus).strength(at, 0.16) + 0.24 * lobe +
         0.13 * floor;
}

/// The keys continued round the circle, so that the curve closes smoothly.
double round_sample(std::span<const Key<double>> keys, double degrees) {
  std::vector<Key<double>> turns;
  for (const double turn : {-360.0, 0.0, 360.0}) {
    for (const Key<double>& key : keys) turns.push_back({key.at + turn, key.value});
  }
  return sample<double>(turns, degrees);
}

double round_sample(const std::array<double, kAngleCount>& values, double degrees) {
  std::array<Key<double>, kAngleCount> keys;
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = {kAngles[i], values[i]};
  return round_sample(keys, degrees);
}

/// The plate that carries the ear: it hangs on the cheek in front and stands off the head behind.
class Plate {
 public:
  Plate(const Identity& who, const Vec3& centre) : centre_(centre), head_(head_of(who)) {}

  /// `back` and `up` along the side of the head from the middle of the ear, `height` off the plate.
  [[nodiscard]] Vec3 at(double back, double up, double height) const {
    const Vec3 place = along(back, up);
    const double hinge = side(along(kHinge, std::clamp(up, -1.35, 1.5)));
    // Its back, its top and the lobe bend towards the head.
    const double off = back - kHinge;
    const double top = std::max(0.0, up - 0.9);
    const double low = std::max(0.0, -up - 1.0);
    const double stands_off = hinge + off * std::tan(kTurn) - 0.035 * off * off - 0.10 * top * top -
                              0.12 * low * low - 0.40 * smooth_step(-1.1, -2.1, up);
    const double hangs = smooth_step(-1.0, -1.9, up);
    const double x =
        mix(side(place) + 0.02 * hangs, stands_off, smooth_step(kHinge - 0.2, kHinge + 0.3, back));
    return Vec3{x, place.y, place.z} + Vec3{std::cos(kTurn), 0, std::sin(kTurn)} * (height + 0.02);
  }

 private:
  static constexpr double kHinge = -0.70;
  static constexpr double kTurn = 0.30;

  [[nodiscard]] Vec3 along(double back, double up) const {
    return centre_ + Vec3{0, -0.06, -0.95} * back + Vec3{0, 0.97, -0.20} * up;
  }
  [[nodiscard]] double side(const Vec3& p) const {
    return leave({0, p.y, p.z}, {1, 0, 0}, head_).x;
  }

  Vec3 centre_;
  Distance head_;
};

}  // namespace

void add_ear_patch(LayoutBuilder& builder) {
  Ring outer = builder.nodes(border_of(kEarBlock));
  Vec3 centre{0};
  for (const std::uint32_t i : outer) centre += builder.position(i) / double{kEarSpokes};
  centre.y += builder.who().form.ear_up;
  const Plate plate(builder.who(), centre);
  const double size = builder.who().form.ear_size;
  for (std::size_t ring = 0; ring < kEarRings; ++ring) {
    Ring inner;
    for (int spoke = 0; spoke < kEarSpokes; ++spoke) {
      double degrees = 120 - spoke * 360.0 / kEarSpokes;
      // Denser at the lobe and at the top, which are the roundest.
      degrees -= 9 * std::sin(radians(2 * (degrees - 280)));
      if (degrees < -60) degrees += 360;
      const double radius =
          size * round_sample(kOutline, degrees) * round_sample(kScale[ring], degrees);
      const double angle = radians(degrees);
      const double back = radius * std::cos(angle);
      const double up = radius * std::sin(angle);
      const double height = ring < kBehind.size() ? round_sample(kBehind[ring], degrees)
                                                  : relief(back / size, up / size);
      inner.push_back(builder.add(plate.at(back, up - 0.05, height), Patch::Ear,
                                  static_cast<int>(ring) + 1, spoke));
    }
    builder.add_strip(outer, inner, true);
    outer = std::move(inner);
  }
  Vec3 middle{0};
  for (const std::uint32_t i : outer) middle += builder.position(i) / double{kEarSpokes};
  builder.add_lid(outer, builder.add(middle - Vec3{0.05, 0, 0}, Patch::Ear, kEarRings + 1));
}

}  // namespace aucast::facegen
