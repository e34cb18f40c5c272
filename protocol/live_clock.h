#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/time.h"
#include "protocol/encoded_stream.h"

namespace aucast::protocol {

/// The one clock of a recorded stream that is sent live. A moment begins when the face should begin
/// to move to its keyframe, and lasts as long as the keyframe's time; after the last one the stream
/// has ended, or starts again. A clock that was not asked for a long time (the computer slept)
/// leaves out what is more than kLiveLagMax past.
/// Thread: none of its own.
class LiveClock {
 public:
  /// The longest delay that is made up for.
  static constexpr Milliseconds kLiveLagMax{1000};

  /// `number` counts the moments from 0 and goes on when the stream starts again.
  struct Moment {
    std::uint64_t number = 0;
    std::size_t keyframe = 0;
    friend bool operator==(const Moment&, const Moment&) = default;
  };

  /// `times`: of each keyframe, at least one; with `loop` their sum must not be 0. Not copied: must
  /// outlive the clock.
  LiveClock(std::span<const KeyframeTime> times, bool loop, Instant begin);

  /// Goes on to the next moment, or to the end, if it is due. Call until it returns false.
  bool advance(Instant now);
  /// Goes through all moments that are due; false when none is.
  bool advance_all(Instant now);
  /// The moments that the last advance went through, the newest last; none when it only ended.
  [[nodiscard]] std::span<const Moment> passed() const { return passed_; }

  /// Nothing before the first moment.
  [[nodiscard]] const std::optional<Moment>& newest() const { return newest_; }
  /// The last keyframe's time is over, and it does not start again.
  [[nodiscard]] bool ended() const { return ended_; }
  /// When advance() has something to do; nothing after the end.
  [[nodiscard]] std::optional<Instant> next_at() const;

 private:
  void step();

  std::span<const KeyframeTime> times_;
  bool loop_;
  Instant next_at_;
  std::size_t next_keyframe_ = 0;
  std::optional<Moment> newest_;
  std::vector<Moment> passed_;
  bool ended_ = false;
};

}  // namespace aucast::protocol
