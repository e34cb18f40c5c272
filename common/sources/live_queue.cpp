#include "common/sources/live_queue.h"

#include <algorithm>
#include <utility>

namespace aucast::sources {

void LiveQueue::push(LiveKeyframe keyframe, SteadySeconds now) {
  const double begin = now - keyframe.seconds;
  if (keyframe.begins) {
    // Behind what is still waiting, if anything is.
    begin_ = queue_.empty() ? begin : queue_.back().due + kLeadSeconds - keyframe.seconds;
  } else if (!keyframe.clocked) {
    // A source without a clock of its own cannot be late.
    begin_ = std::max(begin_, begin);
  }
  last_seconds_ = keyframe.seconds;
  queue_.push_back({std::move(keyframe), begin_ + last_seconds_ - kLeadSeconds});
}

std::optional<double> LiveQueue::due() const {
  if (queue_.empty()) return std::nullopt;
  return queue_.front().due;
}

std::optional<LiveKeyframe> LiveQueue::pop(SteadySeconds now) {
  const auto at = due();
  if (!at || now < *at) return std::nullopt;
  LiveKeyframe keyframe = std::move(queue_.front().keyframe);
  queue_.pop_front();
  return keyframe;
}

void LiveQueue::skip_to_last(SteadySeconds now) {
  if (queue_.empty()) return;
  queue_.erase(queue_.begin(), queue_.end() - 1);
  queue_.front().due = now;
  begin_ = now - last_seconds_;
}

}  // namespace aucast::sources
