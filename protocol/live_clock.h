#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/time.h"

namespace aucast::protocol {

/// What everybody is sent now: a keyframe of the stream. `number` counts the moments from 0 and
/// goes on when the stream starts again, so that who has seen number n and now sees n + 2 has
/// missed one.
struct LiveMoment {
  std::uint64_t number = 0;
  std::size_t keyframe = 0;
  friend bool operator==(const LiveMoment&, const LiveMoment&) = default;
};

/// What the sessions of a live stream go by. Thread: none of its own.
class LiveTime {
 public:
  LiveTime() = default;
  virtual ~LiveTime() = default;

  /// Nothing before the first moment.
  [[nodiscard]] virtual const std::optional<LiveMoment>& newest() const = 0;
  /// The moments that began at once, the newest last; none when it only ended.
  [[nodiscard]] virtual std::span<const LiveMoment> passed() const = 0;
  /// The last keyframe's time is over, and for now nothing follows.
  [[nodiscard]] virtual bool ended() const = 0;
  /// How many moments fit in `time`, rounded up; at least 1.
  [[nodiscard]] virtual std::size_t moments_in(Milliseconds time) const = 0;

 protected:
  LiveTime(const LiveTime&) = default;
  LiveTime& operator=(const LiveTime&) = default;
};

/// The one clock of a recorded stream that is sent live. A moment begins when the face is to set
/// out for its keyframe and lasts as long as the keyframe's time; after the last one the stream has
/// ended, or starts again. A clock that was not asked for long (the computer slept) leaves out what
/// is more than kLiveLagMax past.
/// Thread: none of its own.
class LiveClock final : public LiveTime {
 public:
  /// Longest past that is still made up for.
  static constexpr Milliseconds kLiveLagMax{1000};

  /// `times`: of each keyframe, at least one, none negative; with `loop` their sum must not be 0.
  LiveClock(std::vector<Milliseconds> times, bool loop, Instant begin);

  /// Goes on to the next moment, or to the end, if it is due. Call until it returns false.
  bool advance(Instant now);
  /// Goes through all that is due; false when nothing is.
  bool advance_all(Instant now);
  /// The moments that the last advance went through, the newest last; none when it only ended.
  [[nodiscard]] std::span<const LiveMoment> passed() const override { return passed_; }

  [[nodiscard]] const std::optional<LiveMoment>& newest() const override { return newest_; }
  /// The last keyframe's time is over, and it does not start again.
  [[nodiscard]] bool ended() const override { return ended_; }
  /// When advance() has something to do; nothing after the end.
  [[nodiscard]] std::optional<Instant> next_at() const;
  [[nodiscard]] std::size_t moments_in(Milliseconds time) const override;

 private:
  void step();

  std::vector<Milliseconds> times_;
  Milliseconds sum_{0};
  bool loop_;
  Instant next_at_;
  std::size_t next_keyframe_ = 0;
  std::optional<LiveMoment> newest_;
  std::vector<LiveMoment> passed_;
  bool ended_ = false;
};

}  // namespace aucast::protocol
