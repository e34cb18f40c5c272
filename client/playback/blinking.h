#pragma once

#include <cstdint>

#include "client/playback/interpolator.h"

namespace aucast::playback {

struct BlinkOptions {
  static constexpr int kIntervalMinMs = 500;
  static constexpr int kIntervalMaxMs = 60'000;
  static constexpr int kClosingMinMs = 25;
  static constexpr int kClosingMaxMs = 500;

  std::uint64_t seed = 1;
  /// kIntervalMinMs to kIntervalMaxMs. The default is 15 blinks a minute, as of people at rest.
  int interval_ms = 4000;
  int closing_ms = 100;  ///< kClosingMinMs to kClosingMaxMs, at most a sixth of the interval
  Interpolation interpolation = Interpolation::Linear;
  friend bool operator==(const BlinkOptions&, const BlinkOptions&) = default;
};

/// Blinking as a pure function of time: the same options blink at the same moments. One blink
/// begins in every interval, at a random moment of it, and takes 3 x closing_ms: the lids close in
/// closing_ms, stay closed for half that time and open in one and a half times that time. Returns
/// the closure of both lids in [0,1] at `seconds` >= 0.
[[nodiscard]] float blink_closure(const BlinkOptions& options, double seconds);

}  // namespace aucast::playback
