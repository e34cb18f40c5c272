#include "client/playback/blinking.h"

#include <algorithm>
#include <cmath>

namespace aucast::playback {
namespace {

/// splitmix64: a well mixed number for each pair of seed and interval.
std::uint64_t mixed(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15U;
  value = (value ^ (value >> 30U)) * 0xbf58476d1ce4e5b9U;
  value = (value ^ (value >> 27U)) * 0x94d049bb133111ebU;
  return value ^ (value >> 31U);
}

}  // namespace

float blink_closure(const BlinkOptions& options, double seconds) {
  const double interval_s = options.interval_ms / 1000.0;
  const double closing = std::min(options.closing_ms / 1000.0, interval_s / 6);
  const double closed = closing / 2;
  const double opening = 1.5 * closing;
  const double interval = std::floor(std::max(0.0, seconds) / interval_s);
  const std::uint64_t bits = mixed(mixed(options.seed) ^ static_cast<std::uint64_t>(interval));
  const double unit = static_cast<double>(bits >> 11U) / 9007199254740992.0;  // [0,1)
  const double begin = unit * (interval_s - closing - closed - opening);
  const double t = std::max(0.0, seconds) - interval * interval_s - begin;
  if (t <= 0 || t >= closing + closed + opening) return 0;
  if (t < closing) return ease(options.interpolation, t / closing);
  if (t <= closing + closed) return 1;
  return 1 - ease(options.interpolation, (t - closing - closed) / opening);
}

float blink_closure(std::uint64_t seed, double seconds) {
  BlinkOptions options;
  options.seed = seed;
  return blink_closure(options, seconds);
}

}  // namespace aucast::playback
