#include "client/playback/blinking.h"

#include <algorithm>
#include <cmath>

#include "common/mixed_bits.h"

namespace aucast::playback {

float blink_closure(const BlinkOptions& options, double seconds) {
  const double interval_s = options.interval_ms / 1000.0;
  const double closing = std::min(options.closing_ms / 1000.0, interval_s / 6);
  const double closed = closing / 2;
  const double opening = 1.5 * closing;
  const double interval = std::floor(std::max(0.0, seconds) / interval_s);
  const double begin = chance(options.seed, static_cast<std::uint64_t>(interval)) *
                       (interval_s - closing - closed - opening);
  const double t = std::max(0.0, seconds) - interval * interval_s - begin;
  if (t <= 0 || t >= closing + closed + opening) return 0;
  if (t < closing) return ease(options.interpolation, t / closing);
  if (t <= closing + closed) return 1;
  return 1 - ease(options.interpolation, (t - closing - closed) / opening);
}

}  // namespace aucast::playback
