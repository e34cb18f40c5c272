#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "common/time.h"

namespace aucast::playback {

/// When the keyframes of a live stream are due with the lowest delay that the jitter allows
/// (--live). The face can begin to move to a keyframe only when that has come, so it is delayed by
/// as much as keyframes come late by the stream's own clock, and by no more: each is due its own
/// time after the latest moment at which it could have been expected.
///
/// The lateness is that of the latest keyframe in each of the last 30 seconds, without the worst
/// two seconds, so that a delay that happens once or twice in half a minute does not delay
/// everything after it. A clock that has stepped (a source that stood still, moments that were left
/// out) begins anew after a second.
/// Thread: none of its own.
class LivePlayout {
 public:
  /// A keyframe that takes `time` has come at `now`: when the face should have reached it. `place`:
  /// in the stream, if it is known. The times must not go back.
  [[nodiscard]] Instant arrived(Instant now, Milliseconds time,
                                std::optional<Milliseconds> place = std::nullopt);
  /// From a keyframe's arrival until it is due, the recent average.
  [[nodiscard]] Duration delay() const { return delay_; }
  /// A new connection, or the user has paused: nothing is known of what comes.
  void begin_again() { *this = {}; }

 private:
  struct Second {
    std::int64_t number = 0;
    Duration latest{};
    Duration earliest{};
    std::size_t keyframes = 0;
  };

  void note(Instant now, Duration lateness);
  void forget_before_a_step();
  [[nodiscard]] Duration latest() const;

  std::optional<Instant> begin_;
  Duration sets_out_{};  ///< when the face leaves for the next keyframe, on the stream's clock
  std::optional<Milliseconds> place_;
  std::deque<Second> seconds_;  ///< the last one is under way
  Duration delay_{};
};

}  // namespace aucast::playback
