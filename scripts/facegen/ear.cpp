#include <span>

#include "scripts/facegen/layout_builder.h"
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
                                                {258, 1.86},
                                                {280, 2.06},
                                                {305, 1.74},
                                                {332, 1.45}}};

constexpr std::size_t kAngleCount = 11;
constexpr std::array<double, kAngleCount> kAngles{0,   45,  90,  120, 145, 165,
                                                  185, 205, 230, 270, 315};

/// One ring of the ear: at each of kAngles its share of the outline's radius and its height above
/// the plate of the ear.
struct EarRing {
  std::array<double, kAngleCount> scale;
  std::array<double, kAngleCount> height;
};

constexpr std::array<EarRing, kEarRings> kEar{{
    // behind the ear
    {{.78, .80, .82, .90, 1.06, 1.14, 1.16, 1.14, 1.04, .88, .80},
     {-.12, -.12, -.10, -.04, .00, .00, .00, .01, .00, -.02, -.10}},
    {{.96, .96, .96, .97, 1.00, 1.02, 1.03, 1.02, .99, .97, .96},
     {.18, .18, .16, .12, .05, .03, .02, .05, .08, .10, .14}},
    // the rim, which runs down in front into the shell
    {{1.0, 1.0, 1.0, .99, .95, .93, .92, .92, .94, 1.0, 1.0},
     {.36, .38, .36, .30, .18, .10, .08, .16, .17, .22, .30}},
    {{.955, .955, .95, .93, .87, .83, .81, .82, .87, .95, .96},
     {.46, .50, .50, .44, .32, .20, .12, .27, .24, .30, .38}},
    {{.89, .89, .88, .85, .78, .72, .70, .72, .79, .88, .90},
     {.40, .44, .46, .44, .36, .26, .10, .34, .27, .34, .38}},
    // the furrow inside the rim
    {{.82, .81, .80, .76, .67, .60, .58, .61, .70, .79, .82},
     {.14, .12, .14, .20, .26, .26, .14, .38, .20, .34, .30}},
    {{.73, .72, .71, .66, .56, .49, .47, .50, .60, .69, .73},
     {.10, .04, .00, .02, .08, .20, .06, .36, .16, .34, .22}},
    // the inner ridge; in front the tragus
    {{.63, .62, .61, .55, .45, .39, .37, .40, .49, .58, .62},
     {.40, .34, .16, .02, .00, .14, -.04, .20, .12, .36, .38}},
    {{.54, .52, .49, .44, .36, .31, .30, .31, .39, .48, .52},
     {.50, .46, .30, .12, -.02, .08, -.14, -.16, .04, .30, .46}},
    // down into the shell
    {{.46, .43, .39, .34, .28, .24, .23, .24, .29, .38, .43},
     {.10, .12, .08, .00, -.10, .04, -.26, -.34, -.16, .00, .10}},
    {{.31, .28, .25, .22, .19, .16, .16, .17, .19, .25, .29},
     {-.30, -.26, -.22, -.20, -.22, -.16, -.42, -.46, -.36, -.28, -.26}},
    {{.12, .11, .10, .09, .08, .07, .07, .08, .09, .10, .12},
     {-.42, -.38, -.34, -.34, -.36, -.38, -.54, -.58, -.50, -.42, -.42}},
}};

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
    const double hinge = side(along(kHinge, std::clamp(up, -1.5, 1.7)));
    const double stands_off = hinge + (back - kHinge) * std::tan(kTurn);
    const double x = mix(side(place), stands_off, smooth_step(kHinge - 0.2, kHinge + 0.3, back));
    return Vec3{x, place.y, place.z} + Vec3{std::cos(kTurn), 0, std::sin(kTurn)} * (height + 0.02);
  }

 private:
  static constexpr double kHinge = -0.70;
  static constexpr double kTurn = 0.28;

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
  const Plate plate(builder.who(), centre);
  for (int ring = 1; ring <= kEarRings; ++ring) {
    const EarRing& shape = kEar[static_cast<std::size_t>(ring - 1)];
    Ring inner;
    for (int spoke = 0; spoke < kEarSpokes; ++spoke) {
      double degrees = 120 - spoke * 360.0 / kEarSpokes;
      if (degrees < -60) degrees += 360;
      const double radius = round_sample(kOutline, degrees) * round_sample(shape.scale, degrees);
      const double angle = radians(degrees);
      const Vec3 p = plate.at(radius * std::cos(angle), radius * std::sin(angle) - 0.05,
                              round_sample(shape.height, degrees));
      inner.push_back(builder.add(p, Patch::Ear, ring, spoke));
    }
    builder.add_strip(outer, inner, true);
    outer = std::move(inner);
  }
  Vec3 middle{0};
  for (const std::uint32_t i : outer) middle += builder.position(i) / double{kEarSpokes};
  builder.add_lid(outer, builder.add(middle - Vec3{0.05, 0, 0}, Patch::Ear, kEarRings + 1));
}

}  // namespace aucast::facegen
