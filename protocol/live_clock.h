#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "common/time.h"
#include "protocol/encoded_stream.h"
#include "protocol/limits.h"

namespace aucast::protocol {

/// The clock of a recorded stream that is sent live. A moment begins when the face should begin to
/// move to its keyframe, and lasts as long as the keyframe's time; after the last one the stream
/// ends or starts again. Moments are numbered from 0, and counted on when the stream starts again.
/// Thread: none of its own.
class LiveClock {
 public:
  /// How late a moment may end without being left out, as after the computer has slept.
  static constexpr Milliseconds kLiveLagMax{1000};
  /// How many moments are to be shown at most: no window takes more.
  static constexpr std::size_t kShownMax = kWindowMax;

  /// `times`: the time of each keyframe, at least one; with `loop` their sum must not be 0. They
  /// are not copied and must outlive the clock.
  LiveClock(std::span<const KeyframeTime> times, bool loop, Instant begin);

  /// Goes through all moments that are due, and to the end if that is; returns false if nothing is.
  /// Takes no longer the more turns of a loop are due.
  bool advance(Instant now);

  /// How many moments have begun, those that were left out included.
  [[nodiscard]] std::uint64_t begun() const { return begun_; }
  /// The first of the moments to show since the last advance(): the newest that are not left out,
  /// up to begun(). There is always one, since the last state is shown even if its end is long
  /// past.
  [[nodiscard]] std::uint64_t first_shown() const { return first_shown_; }
  /// Whether the last keyframe's time has passed and the stream does not start again.
  [[nodiscard]] bool ended() const { return ended_; }
  /// The length of a turn, or of the stream that has only one.
  [[nodiscard]] Milliseconds turn() const { return turn_; }
  /// When to call advance() next; nullopt after the end.
  [[nodiscard]] std::optional<Instant> next_at() const;

 private:
  void skip_turns(Instant now);

  std::span<const KeyframeTime> times_;
  Milliseconds turn_{0};
  bool loop_;
  Instant next_at_;
  std::uint64_t begun_ = 0;
  std::uint64_t first_shown_ = 0;
  bool ended_ = false;
};

}  // namespace aucast::protocol
