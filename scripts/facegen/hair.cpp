#include "scripts/facegen/hair.h"

#include "scripts/facegen/distance.h"
#include "scripts/facegen/sculpt.h"

namespace aucast::facegen {
namespace {

constexpr Vec3 kInside{0, 3.2, 0.6};

constexpr std::size_t kShellColumns = 145;
constexpr std::size_t kShellRows = 17;
constexpr std::size_t kLiningColumns = 73;
constexpr std::size_t kLiningRows = 7;
constexpr std::size_t kLocks = 170;
constexpr std::size_t kLockRows = 13;
constexpr std::size_t kLockAcross = 3;

/// Where hair grows: s runs round the hairline in [-12, 12), negative on the right; `inside` from
/// the hairline (0) to the crown (1).
class Scalp {
 public:
  explicit Scalp(const Identity& who) : cut_(who.hair), head_(head_of(who)) {}

  [[nodiscard]] Vec3 hairline(double s) const {
    Vec3 p = sample<Vec3>(cut_.hairline, std::abs(s));
    if (s < 0) p.x = -p.x;
    return p;
  }

  /// From inside the head through the place.
  [[nodiscard]] Vec3 direction(double s, double inside) const {
    const Vec3 from = glm::normalize(hairline(s) - kInside);
    const Vec3 to = glm::normalize(cut_.crown - kInside);
    const double whole = std::acos(std::clamp(glm::dot(from, to), -1.0, 1.0));
    const double way = inside < 0 ? inside : power(inside, 1.2);
    return glm::normalize((from * std::sin((1 - way) * whole) + to * std::sin(way * whole)) /
                          std::sin(whole));
  }

  [[nodiscard]] Vec3 root(double s, double inside) const {
    return leave(kInside, direction(s, inside), head_);
  }

 private:
  const Haircut& cut_;
  Distance head_;
};

/// The outside of a haircut as a sheet: s from 0 to 1 across the hair, t from the roots (0) to the
/// tips (1).
class Sheet {
 public:
  explicit Sheet(const Identity& who)
      : cut_(who.hair), head_(head_of(who)), scalp_(who), who_(who) {}

  [[nodiscard]] bool hangs() const { return !cut_.guides.empty(); }

  [[nodiscard]] Vec3 place(double s, double t) const {
    return hangs() ? hanging(s, t) : cropped(s, t);
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

  [[nodiscard]] Vec3 hanging(double s, double t) const {
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

  [[nodiscard]] Vec3 cropped(double s, double t) const {
    const double round = (s - std::floor(s)) * 24 - 12;
    const double inside = 1 - t;
    const Vec3 direction = scalp_.direction(round, inside);
    const Vec3 root = leave(kInside, direction, head_);
    const double top = smooth_step(4.5, 8.0, root.y);
    const double edge = 1 - power(1 - saturate((inside - 0.03) / cut_.rise), 2.0);
    return root + direction * (0.012 + mix(cut_.side, cut_.top, top) * edge);
  }

  const Haircut& cut_;
  Distance head_;
  Scalp scalp_;
  const Identity& who_;
};

/// Of short hair: 1 over the forehead, 0 behind the temples.
double on_top(double s) {
  return smooth_step(5.2 / 24, 3.2 / 24, std::abs(s - 0.5));
}

Vec3 shade_of(const Identity& who, double light) {
  return mix(who.colours.hair, who.colours.hair_light, saturate(light));
}

void add_shell(Part& hair, const Identity& who, const Sheet& sheet) {
  std::vector<std::vector<std::uint32_t>> rows(kShellRows);
  for (std::size_t i = 0; i < kShellColumns; ++i) {
    const double s = static_cast<double>(i) / (kShellColumns - 1);
    for (std::size_t j = 0; j < kShellRows; ++j) {
      const double t = static_cast<double>(j) / (kShellRows - 1);
      const double way = sheet.hangs() ? 0.965 * t : power(t, 0.7);
      // Short hair is tufts of pepper and salt, with furrows between them.
      const double tuft = value_noise({s * 65, (sheet.hangs() ? 1.5 : 5.0) * t, 0.5});
      Vec3 p = sheet.place(s, way);
      // Under the locks.
      if (sheet.hangs()) {
        p -= sheet.up(s, way) * (0.14 * smooth_step(0, 0.15, t));
      } else {
        p += glm::normalize(p - kInside) * (0.10 * tuft * smooth_step(1, 0.75, t));
      }
      const double shade =
          sheet.hangs() ? 0.32 + 0.25 * tuft : 0.02 + 0.62 * tuft * smooth_step(0, 0.3, t);
      double alpha = 1;
      if (sheet.hangs()) {
        alpha = smooth_step(1, 0.97, t);
      } else {
        const double fringe = 0.05 * (value_noise({s * 150, 1, 3}) + value_noise({s * 420, 1, 5}));
        // Shaved shorter and shorter behind the temples.
        const double softness = who.hair.softness * mix(1.6, 1.0, on_top(s));
        alpha = smooth_step(0, softness, 1 - way - who.hair.ragged * fringe);
      }
      rows[j].push_back(hair.add(p, shade_of(who, shade), alpha));
      hair.vertices.back()[Map::Strand] = s;
    }
  }
  for (std::size_t j = 1; j < kShellRows; ++j) hair.add_band(rows[j], rows[j - 1], false);
}

/// What shows where one looks under hanging hair; short hair has it inside the head.
void add_lining(Part& hair, const Identity& who, const Sheet& sheet) {
  std::vector<std::vector<std::uint32_t>> rows(kLiningRows);
  for (std::size_t i = 0; i < kLiningColumns; ++i) {
    const double s = mix(0.015, 0.985, static_cast<double>(i) / (kLiningColumns - 1));
    for (std::size_t j = 0; j < kLiningRows; ++j) {
      const bool end = j + 1 == kLiningRows;
      const double t = end ? 0.90 + 0.07 * hash(static_cast<std::int64_t>(i))
                           : 0.88 * static_cast<double>(j) / (kLiningRows - 2);
      Vec3 p = sheet.place(s, t);
      p = sheet.hangs() ? p - sheet.up(s, t) * 0.17 : mix(p, kInside, 0.2);
      rows[j].push_back(hair.add(p, who.colours.hair * 0.8));
      hair.vertices.back().gloss = 0;
      hair.vertices.back()[Map::Strand] = s;
    }
  }
  for (std::size_t j = 1; j < kLiningRows; ++j) hair.add_band(rows[j - 1], rows[j], false);
}

struct Lock {
  double s = 0;
  double drift = 0;  ///< to larger s on its way
  double from = 0;   ///< t
  double to = 1;
  double half_width = 0.3;
  double lift = 0.05;      ///< over the sheet, in its middle
  double tip_lift = 0.05;  ///< at its end
  double shade = 0.5;
  double strand = 0;
  double bluntness = 3;  ///< how late it gets pointed
  double pointed = 1;    ///< 0: as wide at its end as before
  double crowded = 1;    ///< above 1: more vertices near the root
};

void add_lock(Part& hair, const Identity& who, const Sheet& sheet, const Lock& lock) {
  std::vector<std::vector<std::uint32_t>> rows(kLockRows);
  for (std::size_t j = 0; j < kLockRows; ++j) {
    const double step = static_cast<double>(j) / (kLockRows - 1);
    const double f = j + 2 == kLockRows ? 0.965 : power(step, lock.crowded);
    const double t = mix(lock.from, lock.to, f);
    // Neighbours wave together.
    const double wave = 0.014 * t * std::sin(9.5 * t + 5 * value_noise({lock.s * 7, 2.5, 0.5}));
    const double s = lock.s + lock.drift * f * f + (sheet.hangs() ? wave : 0);
    const Vec3 middle = sheet.place(s, t);
    const Vec3 across = sheet.across(s, t);
    const Vec3 up = sheet.up(s, t);
    const double taper = (0.22 + 0.78 * smooth_step(0, 0.35, f)) *
                         mix(1, power(1 - power(f, lock.bluntness), 0.7), lock.pointed);
    const double half = lock.half_width * taper + 0.008;
    const double lift =
        lock.lift * std::sin(kPi * std::min(1.0, f * 1.4 + 0.05) * 0.5) + lock.tip_lift * f * f;
    for (std::size_t k = 0; k < kLockAcross; ++k) {
      const double side = static_cast<double>(k) - 1;
      const double belly = 0.30 * half * (1 - side * side);
      // At the roots all have the same shade, or they would look patched where they cross.
      const double light =
          mix(0.36, lock.shade, smooth_step(0, 0.4, f)) + 0.10 * (1 - std::abs(side)) + 0.10 * f;
      const double root = 0.72 + 0.28 * smooth_step(0, 0.25, t);
      // What begins upon other hair comes out of it.
      const bool fades = j + 1 == kLockRows || (j == 0 && sheet.hangs() && lock.from > 0.05);
      const double alpha = fades ? 0 : 1;
      rows[j].push_back(hair.add(middle + across * (half * side) + up * (lift + belly),
                                 shade_of(who, light) * root, alpha));
      hair.vertices.back()[Map::Strand] =
          saturate(lock.strand + side * 0.03 * lock.half_width / 0.3);
    }
  }
  for (std::size_t j = 1; j < kLockRows; ++j) hair.add_band(rows[j], rows[j - 1], false);
}

/// What the n-th lock throws its dice for.
double dice(std::size_t lock, int what) {
  return hash(static_cast<std::int64_t>(lock) * 31 + what * 7919 + 11);
}

/// Long hair: a layer from root to tip, a lighter one that begins lower, and wisps.
Lock hanging_lock(std::size_t i) {
  const auto any = [i](int what) { return dice(i, what); };
  const auto spread = [&](std::size_t first, std::size_t count) {
    return (static_cast<double>(i - first) + any(0)) / static_cast<double>(count);
  };
  Lock lock;
  lock.crowded = 1.08;
  lock.drift = 0.05 * (any(1) - 0.5);
  lock.shade = 0.22 + 0.28 * any(2);
  lock.strand = 0.05 + 0.9 * any(3);
  if (i < 84) {
    lock.s = spread(0, 84);
    lock.from = 0.01 + 0.03 * any(4);
    lock.to = 0.955 + 0.045 * any(5);
    lock.half_width = 0.24 + 0.16 * any(6);
    lock.lift = 0.02 + 0.10 * any(7);
    lock.tip_lift = -0.10 + 0.15 * any(8);
    lock.bluntness = 5;
    lock.pointed = 0.45;
  } else if (i < 134) {
    lock.s = spread(84, 50);
    lock.from = 0.06 + 0.36 * any(4);
    lock.to = 0.84 + 0.13 * any(5);
    lock.half_width = 0.14 + 0.14 * any(6);
    lock.lift = 0.12 + 0.12 * any(7);
    lock.tip_lift = -0.05 + 0.2 * any(8);
    lock.shade += 0.06;
    lock.bluntness = 4;
  } else if (i < 146) {
    lock.s = spread(134, 12);
    lock.drift *= 0.5;
    lock.from = 0.02 + 0.4 * any(4);
    lock.to = std::min(1.0, lock.from + 0.4 + 0.4 * any(5));
    lock.half_width = 0.03 + 0.04 * any(6);
    lock.lift = 0.16 + 0.10 * any(7);
    lock.tip_lift = 0.05 + 0.20 * any(8);
    lock.shade += 0.12;
  } else {
    // Loose at the edges of the face.
    const double in = -0.012 + 0.05 * any(9);
    lock.s = i % 2 == 0 ? in : 1 - in;
    lock.drift = (i % 2 == 0 ? -0.02 : 0.02) * any(1);
    lock.from = 0.02 + 0.25 * any(4);
    lock.to = std::min(1.0, lock.from + 0.35 + 0.4 * any(5));
    lock.half_width = 0.03 + 0.06 * any(6);
    lock.lift = 0.02 + 0.10 * any(7);
    lock.tip_lift = 0.10 * any(8);
    lock.shade += 0.1;
  }
  return lock;
}

/// Short hair: locks all over the shell, longer and more of them on top.
Lock cropped_lock(std::size_t i) {
  const auto any = [i](int what) { return dice(i, what); };
  constexpr double kGolden = 0.6180339887498949;
  // Evenly over the scalp: few near the crown, where flow lines meet.
  const double row = std::sqrt((static_cast<double>(i) + 0.5) / static_cast<double>(kLocks));
  const double from_front = 2 * std::fmod(static_cast<double>(i) * kGolden, 1.0) - 1;
  Lock lock;
  lock.s = 0.5 + 0.5 * from_front * power(std::abs(from_front), 0.3);
  const double top = on_top(lock.s);
  lock.drift = mix(0.008, 0.03, top) * (any(1) - 0.5);
  const double length = mix(0.24, 0.25, top) * (0.7 + 0.6 * any(5));
  lock.to = mix(0.12, mix(0.88, 1.0, top), row) - 0.03 * any(4);
  lock.from = std::max(0.02, lock.to - length);
  lock.half_width = mix(0.09, 0.105, top) * (0.6 + 0.8 * any(6));
  lock.lift = mix(0.03, 0.04, top) + 0.05 * any(7);
  lock.tip_lift = mix(-0.03, 0.20, top) * any(8);
  lock.shade = 0.16 + mix(0.30, 0.42, top) * any(2);
  lock.strand = 0.05 + 0.9 * any(3);
  return lock;
}

}  // namespace

Part make_hair(const Identity& who) {
  const Sheet sheet(who);
  Part hair;
  hair.name = "hair";
  hair.material = face::Material::Hair;
  // From the outside in, so that little is shaded that the next lock hides.
  for (std::size_t i = kLocks; i > 0; --i) {
    add_lock(hair, who, sheet, sheet.hangs() ? hanging_lock(i - 1) : cropped_lock(i - 1));
  }
  add_shell(hair, who, sheet);
  add_lining(hair, who, sheet);
  hair.fill(Map::Head, 1);
  // Short hair lies too unevenly for a band of highlight.
  if (!sheet.hangs()) {
    for (Vertex& vertex : hair.vertices) vertex.gloss *= 0.6;
  }
  return hair;
}

std::vector<ScalpPoint> scalp_of(const Identity& who) {
  const Scalp scalp(who);
  std::vector<ScalpPoint> points;
  for (int i = 0; i < 288; ++i) {
    for (int j = 0; j <= 32; ++j) {
      const double inside = j / 32.0;
      points.push_back({scalp.root(i / 12.0 - 12, inside), inside});
    }
  }
  return points;
}

}  // namespace aucast::facegen
