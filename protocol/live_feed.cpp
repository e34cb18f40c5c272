#include "protocol/live_feed.h"

#include <utility>

namespace aucast::protocol {

LiveFeed::LiveFeed(std::uint32_t keyframe_ms, int classic_min)
    : LiveChannel(true, std::nullopt),
      keyframe_ms_(keyframe_ms),
      encoder_(keyframe_ms, classic_min) {
  limit_window(usual_ms_);
}

void LiveFeed::add(const Keyframe& keyframe) {
  EncodedKeyframe encoded = encoder_.next(keyframe);
  const std::uint64_t number = newest() == nullptr ? 0 : newest()->number + 1;
  moments_.resize(1);
  moments_.front() = {number, std::move(encoded.classic), std::move(encoded.full),
                      std::move(encoded.changes)};
  ended_ = false;
  // The average of about the last ten.
  const double ms = keyframe.duration_ms.value_or(keyframe_ms_);
  usual_ms_ += (ms - usual_ms_) * 0.1;
  // It comes near its value and never quite there.
  constexpr double kSlackMs = 0.001;
  limit_window(usual_ms_ - kSlackMs);
}

}  // namespace aucast::protocol
