#include "scripts/facegen/distance.h"
#include "scripts/facegen/hair.h"
#include "scripts/facegen/hair_parts.h"
#include "scripts/facegen/scalp.h"
#include "scripts/facegen/sculpt.h"

namespace aucast::facegen {
namespace {

/// The outside of long hair: s from 0 to 1 across it, t from the roots (0) to the tips (1).
class Sheet {
 public:
  explicit Sheet(const Identity& who) : cut_(who.hair), head_(head_of(who)), who_(who) {}

  [[nodiscard]] Vec3 place(double s, double t) const {
    const std::size_t last = cut_.guides.size() - 1;
    std::vector<Key<Vec3>> keys;
    for (std::size_t i = 0; i <= last; ++i) {
      keys.push_back({static_cast<double>(i) / static_cast<double>(last), guide(i, t)});
    }
    Vec3 p = sample<Vec3>(keys, saturate(s));
    if (s < 0) p += (keys[0].value - keys[1].value) * (-s * static_cast<double>(last));
    if (s > 1)
      p += (keys[last].value - keys[last - 1].value) * ((s - 1) * static_cast<double>(last));
    const double middle = smooth_step(0, 0.12, s) * smooth_step(1, 0.88, s);
    const double clearance = mix(0.03, mix(0.12, cut_.side, middle), smooth_step(0, 0.2, t));
    for (int i = 0; i < 5; ++i) {
      const double within = clearance - head_(p);
      if (within < 1e-3) break;
      p += head_normal(who_, p) * within;
    }
    return p;
  }

  [[nodiscard]] Vec3 across(double s, double t) const {
    constexpr double kStep = 0.004;
    return glm::normalize(place(s + kStep, t) - place(s - kStep, t));
  }

  [[nodiscard]] Vec3 along(double s, double t) const {
    constexpr double kStep = 0.01;
    return glm::normalize(place(s, std::min(t + kStep, 1.0)) - place(s, std::max(t - kStep, 0.0)));
  }

  /// Away from the head.
  [[nodiscard]] Vec3 up(double s, double t) const {
    return glm::normalize(glm::cross(along(s, t), across(s, t)));
  }

 private:
  [[nodiscard]] Vec3 guide(std::size_t i, double t) const {
    const std::span<const Vec3> points = cut_.guides[i];
    std::vector<Key<Vec3>> keys;
    for (std::size_t k = 0; k < points.size(); ++k) {
      keys.push_back({static_cast<double>(k) / static_cast<double>(points.size() - 1), points[k]});
    }
    return sample<Vec3>(keys, t);
  }

  const Haircut& cut_;
  Distance head_;
  const Identity& who_;
};

void add_outside(Part& hair, const Identity& who, const Sheet& sheet) {
  add_sheet(hair, kOuterSheet, [&](double s, double t) {
    const double way = 0.985 * t;
    const double tuft = value_noise({s * 65, 1.5 * t, 0.5});
    const Vec3 p = sheet.place(s, way) - sheet.up(s, way) * (0.14 * smooth_step(0, 0.15, t));
    const double light = 0.32 + 0.25 * tuft;
    return HairPoint{p, shade_of(who, light), smooth_step(1, 0.9, t), s};
  });
}

/// What shows where one looks under hanging hair.
void add_lining(Part& hair, const Identity& who, const Sheet& sheet) {
  add_sheet(hair, kSecondSheet, [&](double u, double v) {
    const double s = mix(0.985, 0.015, u);  // seen from inside
    const double t = 0.93 * v;
    const Vec3 p = sheet.place(s, t) - sheet.up(s, t) * 0.17;
    return HairPoint{p, who.colours.hair * 0.8, 1, s, 0};
  });
}

}  // namespace

Part make_long_hair(const Identity& who) {
  const Sheet sheet(who);
  Part hair;
  add_outside(hair, who, sheet);
  add_lining(hair, who, sheet);
  return hair;
}

}  // namespace aucast::facegen
