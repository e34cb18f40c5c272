#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/time.h"
#include "protocol/encoded_stream.h"
#include "protocol/limits.h"

namespace aucast::protocol {

/// The clock of a recorded stream that is sent live. A moment begins when the face should begin to
/// move to its keyframe, and lasts as long as the keyframe's time; after the last one the stream
/// ends or starts again. If advance() is not called for a long time (the computer slept), the clock
/// skips moments that are more than kLiveLagMax late.
/// Thread: none of its own.
class LiveClock {
 public:
  /// How late a moment may be without being skipped.
  static constexpr Milliseconds kLiveLagMax{1000};
  /// How many moments passed() has at most, the newest ones: no window takes more.
  static constexpr std::size_t kPassedMax = kWindowMax;

  /// `number` counts the moments from 0, and counts on when the stream starts again.
  struct Moment {
    std::uint64_t number = 0;
    std::size_t keyframe = 0;
    friend bool operator==(const Moment&, const Moment&) = default;
  };

  /// `times`: the time of each keyframe, at least one; with `loop` their sum must not be 0. They
  /// are not copied and must outlive the clock.
  LiveClock(std::span<const KeyframeTime> times, bool loop, Instant begin);

  /// Goes on to the next moment, or to the end, if that is due; else returns false. Call it until
  /// then.
  bool advance(Instant now);
  /// Goes through all moments that are due; returns false if none is. Of a loop that is due many
  /// times over only the last turns are gone through, which takes no longer for more of them.
  bool advance_all(Instant now);
  /// The moments that the last advance() or advance_all() went through, the newest last; empty when
  /// it only reached the end.
  [[nodiscard]] std::span<const Moment> passed() const { return passed_; }

  /// The present moment; nullopt before the first.
  [[nodiscard]] const std::optional<Moment>& newest() const { return newest_; }
  /// Whether the last keyframe's time has passed and the stream does not start again.
  [[nodiscard]] bool ended() const { return ended_; }
  /// The length of a turn, or of the stream that has only one.
  [[nodiscard]] Milliseconds turn() const { return turn_; }
  /// When to call advance() next; nullopt after the end.
  [[nodiscard]] std::optional<Instant> next_at() const;

 private:
  void step();
  void skip_turns(Instant now);

  std::span<const KeyframeTime> times_;
  Milliseconds turn_{0};
  bool loop_;
  Instant next_at_;
  std::size_t next_keyframe_ = 0;
  std::optional<Moment> newest_;
  std::vector<Moment> passed_;
  bool ended_ = false;
};

}  // namespace aucast::protocol
