#include "common/sources/timeline.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "common/time.h"
#include "protocol/limits.h"

namespace aucast::sources {
namespace {

/// The longest time that a face takes to return from neutral after a gap.
constexpr double kReturnSecondsMax = 0.1;

}  // namespace

double remaining(double age_seconds) {
  return std::clamp((kHoldSeconds + kEaseSeconds - age_seconds) / kEaseSeconds, 0.0, 1.0);
}

void Channels::take(double seconds, const AuFrame& update) {
  for (std::size_t number = 1; number < kAuCount; ++number) {
    if (update.left[number] >= 0) {
      values_.left[number] = update.left[number];
      left_seen_seconds_[number] = seconds;
    }
    if (update.right[number] >= 0) {
      values_.right[number] = update.right[number];
      right_seen_seconds_[number] = seconds;
    }
  }
}

AuFrame Channels::at(double seconds) const {
  AuFrame frame = values_;
  for (std::size_t number = 1; number < kAuCount; ++number) {
    frame.left[number] *= static_cast<float>(remaining(seconds - left_seen_seconds_[number]));
    frame.right[number] *= static_cast<float>(remaining(seconds - right_seen_seconds_[number]));
  }
  return frame;
}

bool Timeline::add(double seconds, const AuFrame& update) {
  if (last_seconds_) {
    if (whole_milliseconds(seconds) <= last_ms_) return false;
    bridge(seconds);
    usual_seconds_ = std::min(seconds - *last_seconds_, kReturnSecondsMax);
  }
  channels_.take(seconds, conditioning_.apply(seconds, update));
  store(seconds);
  return true;
}

/// Stands in for missing rows: the held face, the neutral face, and the neutral face until just
/// before the rows go on.
void Timeline::bridge(double until_seconds) {
  const double from = *last_seconds_;
  const double back = until_seconds - usual_seconds_;
  if (back <= from + kHoldSeconds) return;
  store(from + kHoldSeconds);
  if (from + kHoldSeconds + kEaseSeconds < back) store(from + kHoldSeconds + kEaseSeconds);
  store(back);
}

/// Where a keyframe cannot last as long as that, there are several.
void Timeline::store(double seconds) {
  const std::int64_t place = whole_milliseconds(seconds);
  while (last_seconds_ && place - last_ms_ > protocol::kKeyframeTimeMsMax) {
    const std::int64_t step = last_ms_ + protocol::kKeyframeTimeMsMax;
    keep(static_cast<double>(step) / 1000, step);
  }
  if (!last_seconds_ || place > last_ms_) keep(seconds, place);
}

void Timeline::keep(double seconds, std::int64_t place_ms) {
  protocol::Keyframe keyframe;
  keyframe.terms = canonical_terms(channels_.at(seconds));
  keyframe.time_ms = static_cast<std::uint32_t>(last_seconds_ ? place_ms - last_ms_ : 0);
  stream_.keyframes.push_back(std::move(keyframe));
  last_seconds_ = seconds;
  last_ms_ = place_ms;
}

protocol::StreamFile Timeline::finish() {
  std::vector<std::uint32_t> steps;
  for (std::size_t index = 1; index < stream_.keyframes.size(); ++index) {
    steps.push_back(*stream_.keyframes[index].time_ms);
  }
  if (steps.empty()) {
    for (protocol::Keyframe& keyframe : stream_.keyframes) keyframe.time_ms.reset();
  } else {
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    stream_.keyframes.front().time_ms = *middle;
  }
  return std::move(stream_);
}

}  // namespace aucast::sources
