#include "scripts/facegen/distance.h"
#include "scripts/facegen/hair.h"
#include "scripts/facegen/hair_parts.h"
#include "scripts/facegen/scalp.h"
#include "scripts/facegen/sculpt.h"

namespace aucast::facegen {
namespace {

/// The outside of short hair: s from 0 to 1 round the head, t from the crown (0) to the hairline
/// (1).
class Sheet {
 public:
  explicit Sheet(const Identity& who) : cut_(who.hair), head_(head_of(who)), scalp_(who) {}

  [[nodiscard]] Vec3 place(double s, double t) const {
    const double round = (s - std::floor(s)) * 24 - 12;
    const double inside = 1 - t;
    const Vec3 direction = scalp_.direction(round, inside);
    const Vec3 root = leave(kInsideHead, direction, head_);
    const double top = smooth_step(4.5, 8.0, root.y);
    const double edge = 1 - power(1 - saturate((inside - 0.03) / cut_.rise), 2.0);
    return root + direction * (0.012 + mix(cut_.side, cut_.top, top) * edge);
  }

 private:
  const Haircut& cut_;
  Distance head_;
  Scalp scalp_;
};

/// Of short hair: 1 over the forehead, 0 behind the temples.
double on_top(double s) {
  return smooth_step(5.2 / 24, 3.2 / 24, std::abs(s - 0.5));
}

void add_outside(Part& hair, const Identity& who, const Sheet& sheet) {
  add_sheet(hair, kOuterSheet, [&](double s, double t) {
    const double way = power(t, 0.7);
    const double tuft = value_noise({s * 65, 5.0 * t, 0.5});
    Vec3 p = sheet.place(s, way);
    p += glm::normalize(p - kInsideHead) * (0.06 * tuft * smooth_step(1, 0.75, t));
    const double light = 0.1 + 0.5 * tuft * smooth_step(0, 0.3, t);
    // Shaved shorter and shorter behind the temples.
    const double softness = who.hair.softness * mix(1.6, 1.0, on_top(s));
    return HairPoint{p, shade_of(who, light), smooth_step(0, softness, 1 - way), s};
  });
}

}  // namespace

Part make_short_hair(const Identity& who) {
  const Sheet sheet(who);
  Part hair;
  add_outside(hair, who, sheet);
  return hair;
}

}  // namespace aucast::facegen
