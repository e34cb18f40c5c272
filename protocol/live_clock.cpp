#include "protocol/live_clock.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "common/check.h"

namespace aucast::protocol {

LiveClock::LiveClock(std::vector<Milliseconds> times, bool loop, Instant begin)
    : times_(std::move(times)),
      sum_(std::accumulate(times_.begin(), times_.end(), Milliseconds::zero())),
      loop_(loop),
      next_at_(begin) {
  AUCAST_CHECK(!times_.empty());
  AUCAST_CHECK(*std::min_element(times_.begin(), times_.end()) >= Milliseconds::zero());
  AUCAST_CHECK(!loop || sum_ > Milliseconds::zero());
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
  std::vector<LiveMoment> passed;
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
  newest_ = LiveMoment{newest_ ? newest_->number + 1 : 0, next_keyframe_};
  next_at_ += times_[next_keyframe_++];
}

std::optional<Instant> LiveClock::next_at() const {
  if (ended_) return std::nullopt;
  return next_at_;
}

std::size_t LiveClock::moments_in(Milliseconds time) const {
  const auto count = static_cast<Milliseconds::rep>(times_.size());
  const auto sum = std::max(sum_.count(), Milliseconds::rep{1});
  return static_cast<std::size_t>(
      std::max((time.count() * count + sum - 1) / sum, Milliseconds::rep{1}));
}

}  // namespace aucast::protocol
