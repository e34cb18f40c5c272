#pragma once

#include <deque>
#include <optional>

#include "common/time.h"

namespace aucast::playback {

/// Measures by how much a stream has to be delayed so that late keyframes still come in time: the
/// spread of their lateness, against their own times, over the last kWindow. A keyframe that was
/// lost and sent again counts as late as it was.
/// Thread: none of its own.
class JitterMeter {
 public:
  static constexpr Duration kWindow = std::chrono::seconds(30);

  /// A keyframe of `time` has come at `now`; the times must not go back.
  void arrived(Instant now, Milliseconds time);
  /// The spread; nullopt until a keyframe has come, and 0 for only one.
  [[nodiscard]] std::optional<Duration> spread() const;
  /// A new connection: what is known of the link stays, the place in the stream does not.
  void begin_again();

 private:
  struct Arrival {
    Instant at;
    Duration lateness;
  };

  std::deque<Arrival> highest_;  ///< falling: the first is the most late of the window
  std::deque<Arrival> lowest_;   ///< rising: the first is the least late
  std::optional<Instant> begin_;
  Instant last_{};
  Milliseconds media_{0};
  std::optional<Duration> before_;  ///< the spread of the previous connection
};

}  // namespace aucast::playback
