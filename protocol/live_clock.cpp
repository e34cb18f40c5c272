#include "protocol/live_clock.h"

#include <algorithm>
#include <utility>

#include "common/check.h"

namespace aucast::protocol {

LiveClock::LiveClock(std::span<const KeyframeTime> times, bool loop, Instant begin)
    : times_(times), loop_(loop), next_at_(begin) {
  AUCAST_CHECK(!times_.empty());
  AUCAST_CHECK(!loop || std::any_of(times_.begin(), times_.end(),
                                    [](KeyframeTime time) { return time > KeyframeTime::zero(); }));
}

bool LiveClock::advance(Instant now) {
  if (ended_ || now < next_at_) return false;
  passed_.clear();
  step();
  while (!ended_ && now - next_at_ > kLiveLagMax) step();
  if (!ended_) passed_.push_back(*newest_);
  return true;
}

bool LiveClock::advance_all(Instant now) {
  std::vector<Moment> passed;
  bool moved = false;
  while (advance(now)) {
    moved = true;
    passed.insert(passed.end(), passed_.begin(), passed_.end());
  }
  if (moved) passed_ = std::move(passed);
  return moved;
}

void LiveClock::step() {
  if (next_keyframe_ == times_.size()) {
    if (!loop_) {
      ended_ = true;
      return;
    }
    next_keyframe_ = 0;
  }
  newest_ = Moment{newest_ ? newest_->number + 1 : 0, next_keyframe_};
  next_at_ += times_[next_keyframe_++];
}

std::optional<Instant> LiveClock::next_at() const {
  if (ended_) return std::nullopt;
  return next_at_;
}

}  // namespace aucast::protocol
