#include "client/playback/idle_life.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/mixed_bits.h"

namespace aucast::playback {
namespace {

// Different chances of one seed.
constexpr std::uint64_t kWhen = 0x51;
constexpr std::uint64_t kHowFar = 0x52;
constexpr std::uint64_t kWhere = 0x53;
constexpr std::uint64_t kBreathEnd = 0x54;
constexpr std::uint64_t kBreathDepth = 0x55;

double chance_of(std::uint64_t seed, std::uint64_t what, std::int64_t number) {
  return chance(seed + 0x100 * what, static_cast<std::uint64_t>(number));
}

/// Goes from 0 to 1 with no speed at either end.
double smooth(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

struct Gaze {
  double left_deg = 0;
  double up_deg = 0;
};

// === Saccades: one in each slot of time; those with an odd number lead away, the others back.

constexpr double kSlot = 1.5;
constexpr double kDegMin = 1;
constexpr double kDegMax = 3;
constexpr double kFixation = 0.2;  ///< the eyes rest at least so long
constexpr double kSteepest = 0.6;  ///< radians from the horizontal
constexpr double kSaccade = 0.025;
constexpr double kSaccadePerDeg = 0.0024;

Gaze target(std::uint64_t seed, std::int64_t slot) {
  if (slot <= 0 || slot % 2 == 0) return {};
  const double far = kDegMin + (kDegMax - kDegMin) * chance_of(seed, kHowFar, slot);
  const double where = 4 * chance_of(seed, kWhere, slot) - 2;
  const double angle = kSteepest * (where < 0 ? where + 1 : where - 1);
  return {(where < 0 ? -far : far) * std::cos(angle), far * std::sin(angle)};
}

Gaze gaze(std::uint64_t seed, double seconds) {
  const auto slot = static_cast<std::int64_t>(std::floor(seconds / kSlot));
  const Gaze from = target(seed, slot - 1);
  const Gaze to = target(seed, slot);
  const double way = std::hypot(to.left_deg - from.left_deg, to.up_deg - from.up_deg);
  const double duration = kSaccade + kSaccadePerDeg * way;
  const double begin = static_cast<double>(slot) * kSlot + kFixation / 2 +
                       chance_of(seed, kWhen, slot) * (kSlot - duration - kFixation);
  const double share = smooth((seconds - begin) / duration);
  return {from.left_deg + share * (to.left_deg - from.left_deg),
          from.up_deg + share * (to.up_deg - from.up_deg)};
}

// === Breath.

constexpr double kBreath = 4.3;
constexpr double kBreathEarly = 0.33;  ///< a breath ends so much earlier or later
constexpr double kIn = 0.4;
constexpr double kShallowest = 0.75;

double breath_begin(std::uint64_t seed, std::int64_t number) {
  if (number <= 0) return static_cast<double>(number) * kBreath;
  return static_cast<double>(number) * kBreath +
         kBreathEarly * (2 * chance_of(seed, kBreathEnd, number) - 1);
}

double breath(std::uint64_t seed, double seconds) {
  auto number = static_cast<std::int64_t>(std::floor(seconds / kBreath));
  if (seconds < breath_begin(seed, number)) --number;
  if (seconds >= breath_begin(seed, number + 1)) ++number;
  const double begin = breath_begin(seed, number);
  const double t = (seconds - begin) / (breath_begin(seed, number + 1) - begin);
  const double depth = kShallowest + (1 - kShallowest) * chance_of(seed, kBreathDepth, number);
  const double phase = t < kIn ? t / kIn : 1 - (t - kIn) / (1 - kIn);
  return depth * (1 - std::cos(std::numbers::pi * phase)) / 2;
}

}  // namespace

IdleMotion idle_motion(std::uint64_t seed, double seconds) {
  const double at = std::max(0.0, seconds);
  const Gaze looking = gaze(seed, at);
  return {looking.left_deg, looking.up_deg, breath(seed, at)};
}

}  // namespace aucast::playback
