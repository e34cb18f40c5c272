#include "client/playback/jitter_meter.h"

#include <algorithm>

namespace aucast::playback {

void JitterMeter::arrived(Instant now, Milliseconds time) {
  if (!begin_) begin_ = last_ = now;
  const Arrival arrival{now, now - *begin_ - media_};
  media_ += time;
  while (!highest_.empty() && highest_.back().lateness <= arrival.lateness) highest_.pop_back();
  while (!lowest_.empty() && lowest_.back().lateness >= arrival.lateness) lowest_.pop_back();
  highest_.push_back(arrival);
  lowest_.push_back(arrival);
  // Windows end before the previous keyframe, so that a gap of any length shows in the keyframe
  // that ends it.
  while (last_ - highest_.front().at > kWindow) highest_.pop_front();
  while (last_ - lowest_.front().at > kWindow) lowest_.pop_front();
  last_ = now;
  if (before_ && now - *begin_ > kWindow) before_.reset();
}

std::optional<Duration> JitterMeter::spread() const {
  if (!begin_ || highest_.empty()) return before_;
  const Duration spread = highest_.front().lateness - lowest_.front().lateness;
  return std::max(spread, before_.value_or(Duration::zero()));
}

void JitterMeter::begin_again() {
  before_ = spread();
  highest_.clear();
  lowest_.clear();
  begin_.reset();
  media_ = Milliseconds::zero();
}

}  // namespace aucast::playback
