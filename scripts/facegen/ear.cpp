#include <span>

#include "scripts/facegen/layout_builder.h"

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

constexpr std::array<double, 9> kAngles{0, 60, 100, 140, 170, 205, 235, 270, 310};

/// One ring of the ear: at each of kAngles its share of the outline's radius and its height above
/// the side of the head.
struct EarRing {
  std::array<double, 9> scale;
  std::array<double, 9> height;
};

constexpr std::array<EarRing, kEarRings> kEar{{
    // behind the ear
    {{.78, .80, .84, .98, 1.12, 1.12, 1.02, .88, .80},
     {.10, .12, .12, .06, .02, .04, .05, .12, .12}},
    {{.97, .97, .97, .97, .97, .98, .97, .97, .97}, {.34, .34, .30, .14, .05, .10, .14, .24, .28}},
    // the rim
    {{1.00, 1.00, 1.00, .93, .88, .90, .92, .99, 1.00},
     {.52, .54, .48, .27, .11, .24, .24, .34, .42}},
    {{.95, .95, .94, .86, .79, .80, .85, .93, .95}, {.62, .64, .60, .42, .15, .36, .33, .40, .48}},
    {{.88, .88, .87, .77, .69, .70, .76, .84, .87}, {.50, .52, .50, .40, .15, .42, .38, .42, .46}},
    // the furrow inside the rim
    {{.80, .80, .78, .68, .58, .59, .66, .74, .78}, {.26, .26, .27, .32, .11, .38, .38, .40, .40}},
    {{.71, .70, .68, .59, .48, .49, .56, .64, .68}, {.30, .26, .24, .26, .05, .18, .34, .40, .40}},
    // the inner ridge
    {{.61, .59, .56, .50, .40, .40, .46, .53, .58}, {.50, .42, .30, .20, -.01, .02, .26, .40, .46}},
    {{.52, .48, .44, .41, .33, .32, .36, .44, .49},
     {.40, .34, .30, .18, -.07, -.08, .10, .28, .38}},
    // down into the ear
    {{.44, .39, .34, .32, .25, .25, .27, .35, .40},
     {.02, .02, .05, .02, -.18, -.16, -.08, .06, .12}},
    {{.30, .27, .22, .21, .17, .17, .18, .24, .28},
     {-.16, -.14, -.10, -.10, -.26, -.24, -.20, -.06, -.01}},
    {{.12, .11, .10, .09, .08, .07, .08, .10, .12},
     {-.24, -.22, -.22, -.24, -.36, -.32, -.28, -.14, -.08}},
}};

/// The keys continued round the circle, so that the curve closes smoothly.
double round_sample(std::span<const Key<double>> keys, double degrees) {
  std::vector<Key<double>> turns;
  for (const double turn : {-360.0, 0.0, 360.0}) {
    for (const Key<double>& key : keys) turns.push_back({key.at + turn, key.value});
  }
  return sample<double>(turns, degrees);
}

double round_sample(const std::array<double, 9>& values, double degrees) {
  std::array<Key<double>, 9> keys;
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = {kAngles[i], values[i]};
  return round_sample(keys, degrees);
}

}  // namespace

void add_ear_patch(LayoutBuilder& builder) {
  Ring outer = builder.nodes(border_of(kEarBlock));
  Vec3 centre{0};
  for (const std::uint32_t i : outer) centre += builder.position(i) / double{kEarSpokes};
  const Vec3 back = glm::normalize(Vec3{0.40, -0.06, -0.9});
  const Vec3 out = glm::normalize(glm::cross(Vec3{0.06, 0.97, -0.20}, back));
  const Vec3 up = glm::normalize(glm::cross(back, out));
  const Vec3 outward = out.x < 0 ? -out : out;
  const Vec3 upward = up.y < 0 ? -up : up;
  for (int ring = 1; ring <= kEarRings; ++ring) {
    const EarRing& shape = kEar[static_cast<std::size_t>(ring - 1)];
    Ring inner;
    for (int spoke = 0; spoke < kEarSpokes; ++spoke) {
      double degrees = 120 - spoke * 360.0 / kEarSpokes;
      if (degrees < -60) degrees += 360;
      const double radius = round_sample(kOutline, degrees) * round_sample(shape.scale, degrees);
      const double height = round_sample(shape.height, degrees);
      const double angle = radians(degrees);
      const Vec3 p = centre + back * (radius * std::cos(angle)) +
                     upward * (radius * std::sin(angle) - 0.05) + outward * (height + 0.02);
      inner.push_back(builder.add(p, Patch::Ear, ring, spoke));
    }
    builder.add_strip(outer, inner, true);
    outer = std::move(inner);
  }
  Vec3 middle{0};
  for (const std::uint32_t i : outer) middle += builder.position(i) / double{kEarSpokes};
  builder.add_lid(outer, builder.add(middle - outward * 0.05, Patch::Ear, kEarRings + 1));
}

}  // namespace aucast::facegen
