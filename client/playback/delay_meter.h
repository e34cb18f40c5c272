#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/time.h"

namespace aucast::playback {

/// The median and the longest of many delays.
struct DelaySummary {
  std::uint64_t keyframes = 0;  ///< 0: nothing was measured
  Duration median{};            ///< to the millisecond
  Duration longest{};
};

/// Collects delays, such as from a keyframe's arrival until the face has reached it.
/// Thread: none of its own.
class DelayMeter {
 public:
  void add(Duration delay);
  /// The summary of all delays; a median beyond ten seconds is given as ten seconds.
  [[nodiscard]] DelaySummary all() const;
  /// The summary of the last 256.
  [[nodiscard]] DelaySummary lately() const;

 private:
  std::vector<std::uint64_t> by_ms_;  ///< by_ms_[n]: how many delays of n milliseconds, rounded
  std::uint64_t keyframes_ = 0;
  Duration longest_{};
  std::vector<Duration> last_;
  std::size_t next_ = 0;  ///< index into last_ of the oldest, to be overwritten next
};

}  // namespace aucast::playback
