#include "protocol/live_feed.h"

#include "common/check.h"
#include "protocol/codec.h"

namespace aucast::protocol {

LiveFeed::LiveFeed(std::uint32_t keyframe_ms, int classic_min)
    : LiveChannel(true, std::nullopt),
      keyframe_ms_(keyframe_ms),
      classic_min_(classic_min),
      changes_(keyframe_ms) {
  limit_window(usual_ms_);
}

void LiveFeed::add(const Keyframe& keyframe) {
  AUCAST_CHECK(!keyframe.changes_only);
  const std::uint64_t number = newest() == nullptr ? 0 : newest()->number + 1;
  moments_.resize(1);
  moments_.front() = {number, encode_classic(keyframe, classic_min_), encode(keyframe),
                      changes_.next(keyframe)};
  ended_ = false;
  // The average of about the last ten.
  const double ms = keyframe.duration_ms.value_or(keyframe_ms_);
  usual_ms_ += (ms - usual_ms_) * 0.1;
  limit_window(usual_ms_);
}

}  // namespace aucast::protocol
