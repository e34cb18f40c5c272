#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/time.h"

namespace aucast::playback {

/// The usual and the longest of many delays.
struct DelaySummary {
  std::uint64_t keyframes = 0;  ///< 0: nothing was measured
  Duration median{};            ///< to the millisecond
  Duration longest{};
};

/// How long keyframes took from their arrival until the face had reached them.
/// Thread: none of its own.
class DelayMeter {
 public:
  void add(Duration delay);
  /// The summary of all delays; a median beyond ten seconds is given as ten seconds.
  [[nodiscard]] DelaySummary all() const;
  /// The summary of the last 256.
  [[nodiscard]] DelaySummary lately() const;

 private:
  std::vector<std::uint64_t> by_ms_;  ///< how many took each number of milliseconds, rounded
  std::uint64_t keyframes_ = 0;
  Duration longest_{};
  std::vector<Duration> last_;
  std::size_t next_ = 0;  ///< of last_, to be written over
};

}  // namespace aucast::playback
