#include "scripts/facegen/distance.h"
#include "scripts/facegen/hair.h"
#include "scripts/facegen/hair_parts.h"
#include "scripts/facegen/polyline.h"
#include "scripts/facegen/scalp.h"
#include "scripts/facegen/sculpt.h"

namespace aucast::facegen {
namespace {

/// How wide the edge of the hair is in which it gets thinner, by the place on the hairline: shaved
/// shorter and shorter over the ear and in the neck.
constexpr std::array<Key<double>, 9> kTaper{{{0, 0.8},
                                             {2.4, 1.6},
                                             {3.4, 2.7},
                                             {5.0, 2.2},
                                             {5.9, 1.1},
                                             {6.9, 1.1},
                                             {8.0, 2.0},
                                             {9.2, 2.8},
                                             {12, 3.0}}};

/// Height over the skin, away from the edges: short at the sides, longer where the head turns
/// narrow.
double thickness(const Haircut& cut, const Vec3& root) {
  // In front of the ear it lies on the skin.
  const double sideburn = smooth_step(4.2, 1.8, root.y) * smooth_step(0.5, 2.0, root.z);
  return mix(cut.side, cut.top, smooth_step(3.0, 7.6, root.y)) * (1 - 0.8 * sideburn);
}

/// Strands of short hair are coarse: it has fewer.
constexpr double kFirstStrand = 0.05;

/// How far the hair of the temples is brushed back, radians round the pole.
constexpr double kBrushed = 2.5;

/// The alpha of hair in which all strands have ended at 0 and none at 1.
double thinned(double at) {
  return at < 1 ? mix(0.2, 0.8, saturate(at)) : 1;
}

/// Hair in the middle of which is the pole, from which it falls to all sides: s from 0 to 1 round
/// the head, t from the pole (0) to the hairline (1).
class Sides {
 public:
  explicit Sides(const Identity& who)
      : cut_(who.hair),
        head_(head_of(who)),
        scalp_(who),
        pole_(glm::normalize(cut_.crown - kInsideHead)) {
    across_ = glm::normalize(glm::cross(pole_, Vec3{0, 0, 1}));
    ahead_ = glm::cross(across_, pole_);
  }

  [[nodiscard]] HairPoint at(const Identity& who, double s, double t) const {
    const double round = s * 24 - 12;
    const Vec3 direction = scalp_.direction(round, 1 - t);
    const Vec3 root = leave(kInsideHead, direction, head_);
    const auto [from_edge, nearest] = scalp_.edge_from(root);
    const double taper = sample<double>(kTaper, nearest);
    const double tuft = value_noise({round * 2.2, 1.5 * from_edge, 0.5});
    const double grown = smooth_step(0, 1.8 * taper, from_edge);
    const double forehead = smooth_step(6.2, 2.0, std::abs(round));
    const double thick =
        thickness(cut_, root) * grown * (0.75 + 0.5 * tuft) * (1 - 0.8 * forehead) *
        (1 - 0.65 * smooth_step(9.0, 6.0, std::abs(round)) * smooth_step(3.0, 1.0, from_edge));
    // Grey begins at the temples.
    const double temple = smooth_step(7.4, 4.6, root.y) * smooth_step(-5, 0, root.z);
    const double light = 0.05 + 0.54 * temple + 0.12 * tuft + 0.05 * (1 - grown);
    HairPoint point{root + direction * (mix(0.012, 0.03, grown) + thick), shade_of(who, light)};
    const double low = smooth_step(0.9, 2.2, root.z) * smooth_step(3.0, 0.4, root.y);
    // No hairline is drawn with a compass.
    const double astray = 0.8 * (value_noise({round * 2.6, 0.5, 14.5}) - 0.5);
    point.alpha = thinned((from_edge + astray) / taper) * (1 - 0.25 * low);
    // In front the top's own line is the hairline: here strands fork, and would be a notch in it.
    // It ends far behind that line, or its even edge shows between the first strands of the top.
    // Over the temples it must not thin so far back, or one looks through under it from below.
    const double front = smooth_step(4.2, 2.6, std::abs(round));
    point.alpha *= 1 - forehead * smooth_step(mix(1.3, 2.6, front), mix(0.3, 0.9, front),
                                              from_edge + front * astray);
    point.strand = number(direction, s, t);
    point.gloss = mix(0.2, 0.6, grown);
    return point;
  }

 private:
  /// Equally many strands to all sides, combed back as they fall.
  [[nodiscard]] double number(const Vec3& direction, double s, double t) const {
    double angle = std::atan2(glm::dot(direction, across_), glm::dot(direction, ahead_));
    if (s <= 0) angle = -kPi;
    if (s >= 1) angle = kPi;
    // Not by t, which jumps from column to column beside the sideburn.
    const double fallen = std::acos(std::clamp(glm::dot(direction, pole_), -1.0, 1.0)) / 2.1;
    const double above = std::max(0.0, 1 - fallen);
    const double combed = 0.6 * above * above * std::sin(angle);
    // At the temples it is brushed back as the top is that falls on it: where one ends nothing
    // shows but one flow, and along the hairline strands would draw a hem.
    const double aside = std::abs(angle);
    const double back = smooth_step(0, 0.2, aside) * smooth_step(2.6, 0.9, aside);
    const double brushed =
        -kBrushed * std::sin(kPi / 2 * std::min(fallen, 1.0)) * back * (angle < 0 ? -1 : 1);
    const double astray = 0.06 * (value_noise({angle * 4, 4 * t, 3.5}) - 0.5) *
                          smooth_step(kPi, 3.0, std::abs(angle));
    return mix(kFirstStrand, 1.0, 0.5 + (angle + combed + brushed + astray) / (2 * kPi));
  }

  const Haircut& cut_;
  Distance head_;
  Scalp scalp_;
  Vec3 pole_;
  Vec3 across_{1, 0, 0};
  Vec3 ahead_{0, 0, 1};
};

/// What is combed over the pole: u from the parting on the left to the right side, v from the
/// forehead to the back of the head.
class Top {
 public:
  explicit Top(const Identity& who) : cut_(who.hair), head_(head_of(who)) {}

  [[nodiscard]] HairPoint at(const Identity& who, double u, double v) const {
    const Vec3 direction = glm::normalize(guide(u, v) - kInsideHead);
    const Vec3 root = leave(kInsideHead, direction, head_);
    const double sides = smooth_step(0, 0.25, u) * smooth_step(1, 0.5, u);
    const double whole = length(u);
    const double way = v * whole;
    // It springs from the hairline and bends back: a round outline from the side.
    // No two of its tufts stand up alike, or the front is a brim.
    const double stands = value_noise({u * 11, 0.6 * v, 5.5});
    const double front = power(saturate((way - 0.50) / mix(4.2, 2.4, stands)), 0.85);
    const double quiff = 0.42 * stands * bell(way - 2.6, 1.7) * smooth_step(0.3, 2.0, way);
    const double tuft = value_noise({u * 7 + 0.9 * v, 2.6 * v, 7.5});
    const double lock = value_noise({u * 17 + 1.2 * v, 4.5 * v, 9.5});
    const double height =
        0.03 + front * (1.18 * thickness(cut_, root) +
                        (quiff + 0.46 * (tuft - 0.5) + 0.25 * (lock - 0.5)) * sides);
    const double light = 0.02 + 0.03 * front + 0.10 * tuft;
    HairPoint point{root + direction * height, shade_of(who, light)};
    // Here and there it begins a little further back.
    const double begin = way + 0.30 - 0.60 * value_noise({u * 48, 0.5, 4.5}) -
                         0.95 * value_noise({u * 13, 0.5, 8.5});
    const double ends = whole - way - 4 * (tuft - 0.2);
    point.alpha = thinned(std::min({begin / 1.8, ends / 3, u / 0.12, (1 - u) / 0.22}));
    point.gloss = 0.5;
    point.strand = 0.30 * saturate(u + 0.05 * (value_noise({u * 9, 5 * v, 2.5}) - 0.5) *
                                           smooth_step(0, 0.1, u) * smooth_step(1, 0.9, u));
    return point;
  }

 private:
  [[nodiscard]] Vec3 guide(double u, double v) const {
    std::vector<Vec3> row;
    for (const auto& line : cut_.combed) row.push_back(Polyline(line).along(v));
    return Polyline(row).along(u);
  }

  [[nodiscard]] double length(double u) const {
    double sum = 0;
    for (int k = 0; k < 8; ++k) sum += glm::length(guide(u, (k + 1) / 8.0) - guide(u, k / 8.0));
    return sum;
  }

  const Haircut& cut_;
  Distance head_;
};

/// A tuft on top, numbered `number`, that ends where the cut left it and stands off a little.
void add_lock(Part& hair, const Identity& who, const Top& top, std::size_t number) {
  const auto chance = [&](int of) { return hash(static_cast<int>(number) * 43 + of * 6007); };
  const double u0 = mix(0.10, 0.88, static_cast<double>(number) / (kLocks - 1));
  const double begin = mix(0.04, 0.34, chance(1));
  const double length = mix(0.26, 0.44, chance(2));
  const double drift = 0.14 * (chance(3) - 0.35);
  const double lift = mix(0.02, 0.16, chance(4));
  const double half_width = mix(0.022, 0.042, chance(5));
  add_sheet(hair, kLock, [&](double u, double v) {
    const double c = 2 * u - 1;
    const double width = half_width * mix(1, 0.35, v);
    HairPoint point = top.at(who, u0 + c * width + drift * v * v, begin + length * v);
    point.place +=
        glm::normalize(point.place - kInsideHead) * (0.02 + 0.05 * (1 - c * c) + lift * v * v);
    point.alpha = std::min(point.alpha, 0.9 * smooth_step(1, 0.4, std::abs(c)) *
                                            smooth_step(0, 0.25, v) * smooth_step(1, 0.6, v));
    point.strand = 0.30 * saturate(u0 + c * half_width);
    return point;
  });
}

/// A hair on top that lies less flat than the rest.
void add_loose(Part& hair, const Identity& who, const Top& top, std::size_t number) {
  const auto chance = [&](int of) { return hash(static_cast<int>(number) * 61 + of * 7001); };
  const double u = mix(0.06, 0.94, (static_cast<double>(number) + chance(1)) / kStrays);
  const double begin = mix(0.03, 0.6, chance(2));
  const double length = mix(0.14, 0.3, chance(3));
  const double drift = 0.16 * (chance(4) - 0.5);
  const double height = mix(0.06, 0.26, chance(5) * chance(5));
  const auto up = [&](double v) {
    return glm::normalize(top.at(who, u + drift * v * v, begin + length * v).place - kInsideHead);
  };
  const auto at = [&](double v) {
    return top.at(who, u + drift * v * v, begin + length * v).place + up(v) * (height * v);
  };
  add_stray(hair, who, number, at, up);
}

/// A hair of the sides or the back that does not lie as flat as the rest.
void add_loose(Part& hair, const Identity& who, const Sides& sides, std::size_t number) {
  const auto chance = [&](int of) { return hash(static_cast<int>(number) * 73 + of * 7717); };
  const double s = mix(0.02, 0.98, (static_cast<double>(number) + chance(1)) / kStrays);
  const double begin = mix(0.35, 0.78, chance(2));
  const double length = mix(0.08, 0.16, chance(3));
  const double drift = 0.03 * (chance(4) - 0.5);
  const double height = mix(0.03, 0.14, chance(5) * chance(5));
  const auto root = [&](double v) {
    return sides.at(who, s + drift * v, begin + length * v).place;
  };
  const auto up = [&](double v) { return glm::normalize(root(v) - kInsideHead); };
  const auto at = [&](double v) { return root(v) + up(v) * (height * v); };
  add_stray(hair, who, number, at, up);
}

/// A fine hair of the hairline: it grows out of the forehead before the rest and joins it.
void add_first(Part& hair, const Identity& who, const Top& top, std::size_t number) {
  const auto chance = [&](int of) { return hash(static_cast<int>(number) * 67 + of * 5003); };
  const double u = mix(0.05, 0.95, (static_cast<double>(number) + chance(1)) / kWisps);
  const double drift = 0.16 * (chance(2) - 0.45);
  const double begin = mix(-0.10, 0.9, chance(3));
  const double length = mix(0.45, 1.05, chance(4));
  const auto up = [&](double v) {
    return glm::normalize(top.at(who, u + drift * v, 0.08 * v).place - kInsideHead);
  };
  const auto at = [&](double v) {
    const double way = begin + length * v;
    const Vec3 from = top.at(who, u + drift * v, 0).place;
    const Vec3 on = top.at(who, u + drift * v, 0.12).place;
    const Vec3 ahead = glm::normalize(on - from);
    return from + ahead * way + up(v) * mix(0.01, 0.10, v);
  };
  add_wisp(hair, who, mix(0.1, 0.7, chance(5)), at, up);
}

}  // namespace

Part make_short_hair(const Identity& who) {
  const Sides sides(who);
  const Top top(who);
  Part hair;
  add_sheet(hair, kUnderSheet, [&](double s, double t) { return sides.at(who, s, power(t, 0.8)); });
  // Its rows are denser where it rises over the forehead.
  add_sheet(hair, kOuterSheet, [&](double u, double v) { return top.at(who, u, power(v, 1.35)); });
  for (std::size_t i = 0; i < kLocks; ++i) {
    add_lock(hair, who, top, i);
  }
  for (std::size_t i = 0; i < kStrays; ++i) {
    if (i % 2 == 0) {
      add_loose(hair, who, top, i);
    } else {
      add_loose(hair, who, sides, i);
    }
  }
  for (std::size_t i = 0; i < kWisps; ++i) add_first(hair, who, top, i);
  return hair;
}

}  // namespace aucast::facegen
