#pragma once

#include <algorithm>

#include "common/time.h"

namespace aucast::server {

/// When a Follower may ask to join a stream: at once, and again after waits that double from kFirst
/// to kMax, until a stream has gone on for `calm`.
/// Thread: none of its own.
class AskTimes {
 public:
  static constexpr Milliseconds kFirst{250};
  static constexpr Milliseconds kMax{4'000};

  explicit AskTimes(Milliseconds calm) : calm_(calm) {}

  /// When it may ask at the earliest.
  [[nodiscard]] Instant next() const { return next_; }
  /// It may ask at once, however often it has asked before.
  void reset(Instant now) { next_ = now; }
  void on_asked(Instant now) {
    constexpr unsigned kDoublingsMax = 4;
    last_ = now;
    next_ = now + std::min(kFirst * (1U << std::min(asked_++, kDoublingsMax)), kMax);
  }
  void on_answered(Instant now) {
    if (asked_ <= 1) next_ = now;
  }
  /// A stream was joined.
  void on_begun(Instant now) { begun_ = now; }
  /// A stream that was joined goes on.
  void on_gone_on(Instant now) {
    if (now >= begun_ + calm_) asked_ = 0;
  }
  /// Somebody who could answer is there, perhaps only the one that the Follower has just left.
  void on_somebody(Instant now) {
    if (now >= begun_ + calm_) next_ = std::min(next_, last_ + kFirst);
  }

 private:
  Milliseconds calm_;
  Instant next_{};
  Instant last_{};      ///< when it last asked
  Instant begun_{};     ///< when a stream was last joined
  unsigned asked_ = 0;  ///< how often it asked since a stream last went on for calm_
};

}  // namespace aucast::server
