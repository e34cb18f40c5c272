#include "scripts/facegen/distance.h"
#include "scripts/facegen/hair.h"
#include "scripts/facegen/hair_parts.h"
#include "scripts/facegen/polyline.h"
#include "scripts/facegen/scalp.h"
#include "scripts/facegen/sculpt.h"

namespace aucast::facegen {
namespace {

/// Where hair at the front edge leaves the hairline and hangs freely.
double hangs(double t) {
  return smooth_step(0.28, 0.48, t);
}

/// Where its edge turns in; above, it would only dip in and out of the skin.
double rolls(double t) {
  return smooth_step(0.30, 0.50, t);
}

/// The outside of long hair: s from 0 to 1 across it, t from the roots (0) to the tips (1).
class Sheet {
 public:
  explicit Sheet(const Identity& who) : cut_(who.hair), head_(head_of(who)), who_(who) {}

  [[nodiscard]] Vec3 place(double s, double t) const {
    const std::size_t last = cut_.guides.size() - 1;
    std::vector<Vec3> row;
    for (std::size_t i = 0; i <= last; ++i) row.push_back(guide(i, t));
    Vec3 p = Polyline(row).along(saturate(s));
    if (s < 0) p += (row[0] - row[1]) * (-s * static_cast<double>(last));
    if (s > 1) p += (row[last] - row[last - 1]) * ((s - 1) * static_cast<double>(last));
    // Where it lies on the head its height is given, not its place: no guide shows as a bump.
    const double lies = smooth_step(0.50, 0.20, t);
    if (lies > 0) {
      const Vec3 direction = glm::normalize(p - kInsideHead);
      p = mix(p, leave(kInsideHead, direction, head_) + direction * height(s, t), lies);
    }
    const double middle = smooth_step(0, 0.08, s) * smooth_step(1, 0.92, s);
    const double edge = mix(0.04, mix(0.17, 0.24, smooth_step(0.78, 0.9, t)), hangs(t));
    return off_head(p, mix(0.02, mix(edge, cut_.side, middle), smooth_step(0.05, 0.4, t)));
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

  /// The place, or where it is pushed to when it is less than `clearance` from skin or ears.
  [[nodiscard]] Vec3 off_head(Vec3 p, double clearance) const {
    const auto distance = [this](Vec3 q) {
      const Vec3 from_ear = Vec3{std::abs(q.x), q.y, q.z} - Vec3{5.0, 1.5, 1.3};
      return melt(head_(q), ellipsoid(from_ear, {1.0, 2.6, 2.2}), 0.4);
    };
    constexpr double kStep = 0.01;
    for (int i = 0; i < 5; ++i) {
      const double here = distance(p);
      if (here > clearance - 1e-3) break;
      const Vec3 slope{distance(p + Vec3{kStep, 0, 0}) - distance(p - Vec3{kStep, 0, 0}),
                       distance(p + Vec3{0, kStep, 0}) - distance(p - Vec3{0, kStep, 0}),
                       distance(p + Vec3{0, 0, kStep}) - distance(p - Vec3{0, 0, kStep})};
      p += glm::normalize(slope) * (clearance - here);
    }
    return p;
  }

 private:
  /// Over the skin, where the hair lies on the head.
  [[nodiscard]] double height(double s, double t) const {
    const double from_edge = std::min(s, 1 - s);
    // Fuller behind the crown, where the skull falls off.
    const double behind = 0.04 * smooth_step(0.20, 0.5, from_edge) * smooth_step(0, 0.3, t);
    // Beside its edge it clears a forehead that brows raise; the most where it falls across it.
    const double clear = s > 0.5 ? 0.29 : 0.16;
    const double beside =
        mix(0.03, clear, smooth_step(0.0, 0.05, from_edge) * smooth_step(0.06, 0.16, t));
    const double full = mix(beside, cut_.top + behind, smooth_step(0.02, 0.20, from_edge));
    // A narrow valley at the parting, which closes towards the crown.
    const double valley = mix(0.20, 0.04, smooth_step(0.03, 0.2, from_edge));
    const double rise = 1 - std::exp(-std::pow(t / 0.05, 2));
    return full * mix(1, rise, valley);
  }

  [[nodiscard]] Vec3 guide(std::size_t i, double t) const {
    // The front edge is on the skin as far as it is the hairline.
    const bool front = i == 0 || i + 1 == cut_.guides.size();
    const Vec3 p = Polyline(cut_.guides[i]).along(t);
    const double rooted = front ? 1 - hangs(t) : 0;
    return rooted > 0 ? mix(p, on_skin(who_, p), rooted) : p;
  }

  const Haircut& cut_;
  Distance head_;
  const Identity& who_;
};

/// Share of the outer sheet's columns on either side that turn in at the front edge.
constexpr double kRolled = 0.03;

/// A place on the outside with its front edges, which turn in towards the face.
struct Outside {
  double s = 0;
  double rolled = 0;  ///< from the edge (0) to its innermost part (1)
  double side = 0;    ///< -1 on the left
};

Outside outside_at(double u) {
  const double side = u < 0.5 ? -1 : 1;
  const double from_edge = std::min(u, 1 - u);
  return {saturate((u - kRolled) / (1 - 2 * kRolled)), saturate(1 - from_edge / kRolled), side};
}

/// How far big soft waves and smaller locks stand out.
double waves(double s, double t) {
  const double free = smooth_step(0.1, 0.5, t);
  const double astray = value_noise({s * 17, 2.2 * t, 11.5}) - 0.5;
  return free * (0.13 * std::sin(2 * kPi * (5.3 * s + 0.7 * t)) +
                 0.13 * std::sin(2 * kPi * (3.1 * s - 1.5 * t) + 1) + 0.30 * astray +
                 0.20 * (value_noise({s * 37 + 1.5 * t, 1.6 * t, 17.5}) - 0.5) +
                 0.035 * std::sin(2 * kPi * (13.7 * s - 0.9 * t) + 2 * std::sin(17 * s)));
}

/// The outside with its waves and with tips that turn in.
Vec3 outer_place(const Sheet& sheet, double across, double t) {
  // It bends to the sides, too, its front edges as well: straight, they are a curtain's.
  const double s = across + smooth_step(0.30, 0.85, t) *
                                (0.013 * std::sin(2 * kPi * (1.9 * t + 2.3 * across)) +
                                 0.007 * std::sin(2 * kPi * (3.4 * t - 7.1 * across) + 1));
  const double tip = smooth_step(0.70, 1, t);
  // The front edges lie on the cheeks already.
  const double free = smooth_step(0, 0.07, std::min(s, 1 - s));
  // No two locks turn in alike.
  const double turned =
      mix(0.30, 0.75, value_noise({s * 23, 0.5, 13.5})) * smooth_step(0, 0.18, std::min(s, 1 - s));
  return sheet.place(s, t) + sheet.up(s, t) * (free * waves(s, t) - turned * tip * tip);
}

/// Number of the strand: they gather into locks, the more the farther down.
double strand_at(double u, double t) {
  // Hair of the hairline runs back from it.
  const double lean = 0.11 * smooth_step(0.60, 0, t) * (1 - 2 * u);
  const double inside = smooth_step(0, 0.08, u) * smooth_step(1, 0.92, u);
  const double gather =
      0.0018 * std::sin(2 * kPi * (29 * u + 0.6 * t)) +
      0.0110 * std::sin(2 * kPi * (1.35 * t + 1.7 * u)) * smooth_step(0.1, 0.5, t) +
      0.0006 * std::sin(2 * kPi * (67 * u - 1.1 * t) + 3 * std::sin(11 * u));
  return u + lean + inside * gather * smooth_step(0.05, 0.8, t);
}

void add_outside(Part& hair, const Identity& who, const Sheet& sheet) {
  add_sheet(hair, kOuterSheet, [&](double u, double v) {
    const double t = mix(v, v * v, 0.45);
    const Outside at = outside_at(u);
    const double s = at.s;
    Vec3 p = outer_place(sheet, s, t);
    if (at.rolled > 0) {
      const double wide = mix(0.10, 0.36, rolls(t)) * mix(1, 0.6, smooth_step(0.8, 1, t));
      p += sheet.across(s, t) * (at.side * wide * at.rolled) -
           sheet.up(s, t) * (mix(0.10, 0.36, rolls(t)) * at.rolled * at.rolled);
    }
    // A parting is no straight line, and the roots along it lie in their own shade.
    const double from_edge = std::min(s, 1 - s);
    const double jagged = value_noise({from_edge * 70, 0.5, 15.5}) +
                          0.6 * value_noise({from_edge * 170, 0.5, 16.5}) - 0.8;
    p.x += 0.22 * jagged * std::exp(-std::pow(t / 0.05, 2)) * smooth_step(0.03, 0.08, from_edge);
    // What lies between the waves is the darker layer below.
    const double valley = smooth_step(0.06, -0.22, waves(s, t));
    const double deep = (1 - 0.14 * std::exp(-std::pow(t / 0.016, 2))) * (1 - 0.50 * valley);
    const double tuft = value_noise({s * 60 + 2.5 * t, 1.5 * t, 0.5});
    // The left side of the parting turns away from the lamp: of one colour, both meet in a step.
    const double parted =
        mix(0.24, 0.16, smooth_step(0.2, 0.8, s)) * std::exp(-std::pow(t / 0.13, 2));
    const double light = 0.30 * tuft + 0.60 * t - 0.18 * at.rolled * rolls(t) + parted;
    const double loose = smooth_step(0.14, 0.34, t);
    const double soft = mix(0.025, 0.075, value_noise({0.5, 26 * t, 9.5}));
    // Where it hangs single strands of the edge lie on the cheek.
    const double begin = -kRolled * loose;
    const double hairline =
        smooth_step(begin, begin + mix(soft, 1.2 * kRolled, smooth_step(0.10, 0.22, t)),
                    from_edge - kRolled * at.rolled);
    // The scalp shows along the front of the parting alone: at the crown one would look through.
    const double parting =
        mix(1, smooth_step(-0.004, 0.040, t), 0.45 * smooth_step(0.14, 0.06, from_edge));
    // In front its ends are one lock: two look like a fork.
    const double whole = 0.7 * smooth_step(0.22, 0.10, from_edge);
    const double ragged =
        0.5 * value_noise({s * 38, 0.5, 3.5}) + 0.5 * value_noise({s * 11, 0.5, 6.5});
    const double full =
        0.80 + 0.18 * mix(ragged, 1, whole) - 0.03 * smooth_step(0.06, 0, from_edge);
    const double ends = smooth_step(full + 0.10, full - 0.06, t) * smooth_step(1, 0.95, t);
    // Not quite whole, the edge is drawn before a cheek that a wide mouth pushes out.
    const double edge = from_edge < 0.06 && t > 0.4 ? 0.99 : 1;
    return HairPoint{p, deep * shade_of(who, light), edge * hairline * parting * ends,
                     strand_at(u, t), mix(0.5, 1, smooth_step(0, 0.2, t))};
  });
}

/// What shows where one looks under hanging hair.
void add_lining(Part& hair, const Identity& who, const Sheet& sheet) {
  add_sheet(hair, kUnderSheet, [&](double u, double v) {
    const double s = mix(0.96, 0.04, u);  // seen from inside
    const double t = mix(0.3, 0.975, v);
    const double thick = mix(0.42, 0.25, smooth_step(0.8, 1, t));
    const Vec3 p = sheet.off_head(outer_place(sheet, s, t) - sheet.up(s, t) * thick, 0.04);
    // From the front its edge is seen beside the cheek: dark and straight, it is a slit.
    const double front = std::min(u, 1 - u);
    const double light = 0.10 + 0.12 * smooth_step(0.10, 0.0, front);
    const double ragged = 0.3 * value_noise({s * 60, 0.5, 2.5});
    // Behind the neck it reaches as far down as the outside: else one looks through below the jaw.
    const double behind = smooth_step(0.08, 0.22, front);
    const double ends =
        smooth_step(1, 0.9, v) * smooth_step(mix(0.88, 1.02, behind), mix(0.56, 0.90, behind),
                                             v + ragged * smooth_step(0.2, 0.0, front));
    return HairPoint{p, shade_of(who, light) * mix(0.9, 1.2, v), ends * smooth_step(0, 0.02, front),
                     s, 0};
  });
}

void add_lock(Part& hair, const Identity& who, const Sheet& sheet, const Lock& lock) {
  add_sheet(hair, kLock, [&](double u, double v) {
    const double t = mix(lock.begin, lock.end, v);
    const double c = 2 * u - 1;
    const double width = lock.width * mix(1, 0.45, v);
    const double s = lock.s + lock.drift * v * v + c * width;
    const double way = std::min(t, 1.0);
    constexpr double kLength = 16;
    const double over = lock.over * smooth_step(0, 0.3, v) + lock.lift * v * v * v;
    const Vec3 p = outer_place(sheet, s, way) + sheet.up(s, way) * (over + 0.02 * (1 - c * c)) +
                   sheet.along(s, way) * ((t - way) * kLength);
    const double alpha = lock.cover * smooth_step(1, 0.4, std::abs(c)) * smooth_step(0, 0.25, v) *
                         smooth_step(1, 0.7, v);
    return HairPoint{p, shade_of(who, 0.36 + 0.22 * t), alpha, saturate(lock.s + c * lock.width)};
  });
}

/// A hair that has come loose somewhere between the roots and the ends.
void add_loose(Part& hair, const Identity& who, const Sheet& sheet, std::size_t number) {
  const auto chance = [&](int of) { return hash(static_cast<int>(number) * 61 + of * 7001); };
  const double s = mix(0.08, 0.92, (static_cast<double>(number) + chance(1)) / kStrays);
  const double begin = mix(0.04, 0.62, chance(2) * chance(2));
  const double length = mix(0.18, 0.42, chance(3));
  const double drift = 0.09 * (chance(4) - 0.5);
  const double height = mix(0.05, 0.34, chance(5) * chance(5));
  const auto across = [&](double v) { return s + drift * v * v; };
  const auto along = [&](double v) { return begin + length * v; };
  const auto up = [&](double v) { return sheet.up(across(v), along(v)); };
  const auto at = [&](double v) {
    return outer_place(sheet, across(v), along(v)) + up(v) * (height * smooth_step(0, 0.6, v));
  };
  add_stray(hair, who, number, at, up);
}

/// A fine hair that leaves the front edge for the face, on both sides in turn.
void add_edge_wisp(Part& hair, const Identity& who, const Sheet& sheet, std::size_t number) {
  const auto chance = [&](int of) { return hash(static_cast<int>(number) * 67 + of * 5003); };
  const double side = number % 2 == 0 ? -1 : 1;
  const double from_edge = mix(0.004, 0.030, chance(1));
  const double s = side < 0 ? from_edge : 1 - from_edge;
  const std::size_t of_its_side = number / 2;
  const double begin = mix(0.06, 0.50, (static_cast<double>(of_its_side) + chance(2)) * 2 / kWisps);
  const double length = mix(0.12, 0.26, chance(3));
  const double strays = mix(0.2, 0.8, chance(4) * chance(4));
  const auto along = [&](double v) { return begin + length * v; };
  const auto up = [&](double v) { return sheet.up(s, along(v)); };
  const auto at = [&](double v) {
    const double out = strays * std::sin(2.6 * v) + 0.10 * v;
    const Vec3 p = outer_place(sheet, s, along(v)) + sheet.across(s, along(v)) * (side * out);
    return p + up(v) * 0.08;
  };
  add_wisp(hair, who, mix(0.4, 0.9, chance(5)), at, up);
}

}  // namespace

Part make_long_hair(const Identity& who) {
  const Sheet sheet(who);
  Part hair;
  add_lining(hair, who, sheet);  // behind
  add_outside(hair, who, sheet);
  for (std::size_t i = 0; i < kLocks; ++i)
    add_lock(hair, who, sheet, who.hair.locks[i % who.hair.locks.size()]);
  for (std::size_t i = 0; i < kStrays; ++i) add_loose(hair, who, sheet, i);
  for (std::size_t i = 0; i < kWisps; ++i) add_edge_wisp(hair, who, sheet, i);
  return hair;
}

}  // namespace aucast::facegen
