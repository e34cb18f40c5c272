#include "protocol/live_clock.h"

#include <algorithm>

#include "common/check.h"

namespace aucast::protocol {

LiveClock::LiveClock(std::span<const KeyframeTime> times, bool loop, Instant begin)
    : times_(times), loop_(loop), next_at_(begin) {
  AUCAST_CHECK(!times_.empty());
  for (const KeyframeTime time : times_) turn_ += time;
  AUCAST_CHECK(!loop || turn_ > Milliseconds{0});
}

bool LiveClock::advance(Instant now) {
  if (ended_ || now < next_at_) return false;
  skip_turns(now);
  first_shown_ = begun_;
  while (now >= next_at_) {
    if (!loop_ && begun_ == times_.size()) {
      ended_ = true;
      break;
    }
    next_at_ += times_[begun_++ % times_.size()];
    if (now - next_at_ > kLiveLagMax) first_shown_ = begun_;
  }
  const std::uint64_t newest = begun_ - 1;
  const std::uint64_t oldest = begun_ - std::min<std::uint64_t>(begun_, kShownMax);
  first_shown_ = std::clamp(first_shown_, oldest, newest);
  return true;
}

/// Leaves out whole turns of a loop, so many that all moments to show are still to come.
void LiveClock::skip_turns(Instant now) {
  if (!loop_) return;
  const auto due = static_cast<std::uint64_t>((now - next_at_) / turn_);
  const std::uint64_t kept = kShownMax / times_.size() + 2;
  if (due <= kept) return;
  begun_ += (due - kept) * times_.size();
  next_at_ += static_cast<std::int64_t>(due - kept) * turn_;
}

std::optional<Instant> LiveClock::next_at() const {
  if (ended_) return std::nullopt;
  return next_at_;
}

}  // namespace aucast::protocol
