#include "common/sources/live_queue.h"

#include <algorithm>
#include <utility>

namespace aucast::sources {

void LiveQueue::push(LiveKeyframe keyframe, SteadyTime now) {
  const Seconds place(keyframe.seconds);
  const SteadyTime begin = now - place;
  if (keyframe.begins) {
    // Behind what is still waiting, if anything is.
    begin_ = queue_.empty() ? begin : queue_.back().due + kLead - place;
  } else if (!keyframe.clocked) {
    // A source without a clock of its own cannot be late.
    begin_ = std::max(begin_, begin);
  }
  last_ = place;
  queue_.push_back({std::move(keyframe), begin_ + last_ - kLead});
}

std::optional<SteadyTime> LiveQueue::due() const {
  if (queue_.empty()) return std::nullopt;
  return queue_.front().due;
}

std::optional<LiveKeyframe> LiveQueue::pop(SteadyTime now) {
  const auto at = due();
  if (!at || now < *at) return std::nullopt;
  LiveKeyframe keyframe = std::move(queue_.front().keyframe);
  queue_.pop_front();
  return keyframe;
}

void LiveQueue::skip_to_last(SteadyTime now) {
  if (queue_.empty()) return;
  queue_.erase(queue_.begin(), queue_.end() - 1);
  queue_.front().due = now;
  begin_ = now - last_;
}

}  // namespace aucast::sources
