#pragma once

#include <deque>
#include <optional>

#include "common/time.h"

namespace aucast::playback {

/// Measures by how much a stream has to be delayed so that late keyframes still come in time. A
/// keyframe's lateness is how long after the first keyframe it arrived, minus the sum of the times
/// of all keyframes before it; the result is the spread of lateness over the last kWindow. A
/// keyframe that was lost and sent again counts with all of its lateness.
/// Thread: none of its own.
class JitterMeter {
 public:
  static constexpr Duration kWindow = std::chrono::seconds(30);

  /// A keyframe of length `time` has come at `now`, which must not go back.
  void arrived(Instant now, Milliseconds time);
  /// The spread; nullopt until a keyframe has come, and 0 after only one.
  [[nodiscard]] std::optional<Duration> spread() const;
  /// Call it for a new connection: the spread is remembered, the place in the stream is not.
  void begin_again();

 private:
  struct Arrival {
    Instant at;
    Duration lateness;
  };

  std::deque<Arrival> highest_;  ///< with falling lateness; the first has the highest of the window
  std::deque<Arrival> lowest_;   ///< with rising lateness; the first has the lowest of the window
  std::optional<Instant> begin_;
  Instant last_{};
  Milliseconds media_{0};
  std::optional<Duration> before_;  ///< the spread of the previous connection, used for one more
                                    ///< kWindow
};

}  // namespace aucast::playback
