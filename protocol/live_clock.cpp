#include "protocol/live_clock.h"

#include <utility>

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
  passed_.clear();
  step();
  while (!ended_ && now - next_at_ > kLiveLagMax) step();
  if (!ended_) passed_.push_back(*newest_);
  return true;
}

bool LiveClock::advance_all(Instant now) {
  skip_turns(now);
  std::vector<Moment> passed;
  const auto keep_newest = [&] {
    if (passed.size() <= kPassedMax) return;
    passed.erase(passed.begin(), passed.end() - static_cast<std::ptrdiff_t>(kPassedMax));
  };
  bool moved = false;
  while (advance(now)) {
    moved = true;
    passed.insert(passed.end(), passed_.begin(), passed_.end());
    if (passed.size() == 2 * kPassedMax) keep_newest();
  }
  keep_newest();
  if (moved) passed_ = std::move(passed);
  return moved;
}

/// Leaves out whole turns of a loop, so many that what passed() will have is still to come.
void LiveClock::skip_turns(Instant now) {
  if (!loop_ || !newest_ || now < next_at_) return;
  const auto due = static_cast<std::uint64_t>((now - next_at_) / turn_);
  const std::uint64_t kept = kPassedMax / times_.size() + 2;
  if (due <= kept) return;
  const std::uint64_t skipped = due - kept;
  newest_->number += skipped * times_.size();
  next_at_ += static_cast<std::int64_t>(skipped) * turn_;
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
