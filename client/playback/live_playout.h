#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "common/time.h"

namespace aucast::playback {

/// Decides when the keyframes of a live stream are due, with the lowest delay that the jitter
/// allows (--live). The face can begin to move to a keyframe only when the keyframe has come. So
/// the face is delayed by the lateness of keyframes, compared with the stream's own clock, and by
/// no more: a keyframe is due when it would come if it had the expected lateness, plus its own
/// time.
///
/// The expected lateness is the largest of the last 30 seconds without the two worst seconds, so
/// that a delay that happens once or twice in half a minute does not delay everything after it. If
/// the stream's clock has stepped (the source was silent, or moments were left out), what was known
/// before is forgotten after a second.
/// Thread: none of its own.
class LivePlayout {
 public:
  /// A keyframe of length `time` has come at `now`. Returns when the face should have reached it.
  /// `place`: its place in the stream, if known. `now` must not go back.
  [[nodiscard]] Instant arrived(Instant now, Milliseconds time,
                                std::optional<Milliseconds> place = std::nullopt);
  /// The recent average of the time from a keyframe's arrival until it is due.
  [[nodiscard]] Duration delay() const { return delay_; }
  /// Call it for a new connection or when the user has paused: forgets everything.
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
  std::deque<Second> seconds_;  ///< the last one is not over yet
  Duration delay_{};
};

}  // namespace aucast::playback
