#include "protocol/live_feed.h"

#include <utility>

namespace aucast::protocol {

LiveFeed::LiveFeed(std::uint32_t keyframe_ms, int classic_min, bool voice, bool captions,
                   std::optional<std::uint64_t> duration_ms)
    : LiveChannel(true, duration_ms, {voice, captions}),
      keyframe_ms_(keyframe_ms),
      encoder_(keyframe_ms, classic_min) {
  limit_window(usual_ms_);
}

void LiveFeed::add(const Keyframe& keyframe) {
  add(encoder_.next(keyframe), Milliseconds(keyframe.time_ms.value_or(keyframe_ms_)));
}

void LiveFeed::add(EncodedKeyframe encoded, Milliseconds time) {
  const std::uint64_t number = newest() == nullptr ? 0 : newest()->number + 1;
  if (std::exchange(moments_told_, false) || !together_) moments_.clear();
  if (moments_.size() == kLatestMax) moments_.erase(moments_.begin());
  moments_.push_back({number, std::move(encoded.classic), std::move(encoded.full),
                      std::move(encoded.changes), end_, time});
  end_ += time;
  ended_ = false;
  // The average of about the last ten.
  usual_ms_ += (static_cast<double>(time.count()) - usual_ms_) * 0.1;
  // It comes near its value and never quite there.
  constexpr double kSlackMs = 0.001;
  limit_window(usual_ms_ - kSlackMs);
}

void LiveFeed::add_voice(EncodedVoice voice) {
  if (has_voice()) keep(std::move(voice));
}

void LiveFeed::add_caption(CaptionData caption) {
  if (has_captions()) keep(std::move(caption));
}

}  // namespace aucast::protocol
