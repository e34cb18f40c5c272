#include "protocol/live_feed.h"

#include <algorithm>
#include <cmath>

#include "common/check.h"
#include "protocol/codec.h"

namespace aucast::protocol {

LiveFeed::LiveFeed(std::uint32_t keyframe_ms, int classic_min)
    : keyframe_ms_(keyframe_ms), classic_min_(classic_min), changes_(keyframe_ms) {}

void LiveFeed::attach(const std::shared_ptr<ServedStream>& stream) {
  std::erase_if(streams_, [](const auto& other) { return other.expired(); });
  streams_.push_back(stream);
  stream->clock = this;
  stream->times.clear();
  stream->duration_ms.reset();
  show(*stream);
}

void LiveFeed::show(ServedStream& stream) const {
  stream.classic.assign(1, classic_);
  stream.negotiated.assign(1, full_);
  stream.changes.assign(1, changed_);
}

void LiveFeed::add(const Keyframe& keyframe) {
  AUCAST_CHECK(!keyframe.changes_only);
  classic_ = encode_classic(keyframe, classic_min_);
  full_ = encode(keyframe);
  changed_ = changes_.next(keyframe);
  for (const auto& held : streams_) {
    if (const auto stream = held.lock()) show(*stream);
  }
  // The average of about the last ten.
  const double ms = keyframe.duration_ms.value_or(keyframe_ms_);
  usual_ms_ += (ms - usual_ms_) * 0.1;
  newest_ = LiveMoment{newest_ ? newest_->number + 1 : 0, 0};
  ended_ = false;
}

std::size_t LiveFeed::moments_in(Milliseconds time) const {
  // The average comes near what came lately, never quite there.
  const double moments = static_cast<double>(time.count()) / std::max(usual_ms_, 1.0);
  return static_cast<std::size_t>(std::max(std::ceil(moments - 0.01), 1.0));
}

}  // namespace aucast::protocol
