#include "client/playback/blinking.h"

#include <algorithm>
#include <cmath>

namespace aucast::playback {
namespace {

constexpr double kInterval = 4.0;  // 15 blinks a minute, as people at rest do
constexpr double kClosing = 0.10;
constexpr double kClosed = 0.05;
constexpr double kOpening = 0.15;

/// splitmix64: a well mixed number for each pair of seed and interval.
std::uint64_t mixed(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15U;
  value = (value ^ (value >> 30U)) * 0xbf58476d1ce4e5b9U;
  value = (value ^ (value >> 27U)) * 0x94d049bb133111ebU;
  return value ^ (value >> 31U);
}

}  // namespace

float blink_closure(std::uint64_t seed, double seconds) {
  const double interval = std::floor(std::max(0.0, seconds) / kInterval);
  const std::uint64_t bits = mixed(mixed(seed) ^ static_cast<std::uint64_t>(interval));
  const double unit = static_cast<double>(bits >> 11U) / 9007199254740992.0;  // [0,1)
  const double begin = unit * (kInterval - kClosing - kClosed - kOpening);
  const double t = std::max(0.0, seconds) - interval * kInterval - begin;
  if (t <= 0) return 0;
  if (t < kClosing) return static_cast<float>(t / kClosing);
  if (t <= kClosing + kClosed) return 1;
  return static_cast<float>(std::max(0.0, 1 - (t - kClosing - kClosed) / kOpening));
}

}  // namespace aucast::playback
