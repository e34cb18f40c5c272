#include "protocol/live_channel.h"

#include <algorithm>
#include <utility>

#include "protocol/limits.h"

namespace aucast::protocol {

void LiveChannel::limit_window(double mean_ms) {
  const double moments = static_cast<double>(kLiveWindowTime.count()) / std::max(mean_ms, 1.0);
  window_max_ = std::max(static_cast<std::size_t>(moments), std::size_t{2});
}

void LiveChannel::keep(EncodedVoice voice) {
  if (!voice_.empty() && voice.begin < voice_.back().end) return;
  const Milliseconds past = voice.end - kLiveWindowTime;
  voice_.push_back(std::move(voice));
  while (voice_.front().end < past) voice_.pop_front();
}

void LiveChannel::keep(CaptionData caption) {
  captions_.push_back(std::move(caption));
  const Milliseconds now = newest() == nullptr ? Milliseconds{0} : newest()->begin;
  const auto stands = [&] {
    const CaptionData* const second = captions_.find(captions_.first_number() + 1);
    return second == nullptr || Milliseconds(second->place_ms) > now;
  };
  while (!stands() || captions_.size() > kLiveCaptionsMax) {
    if (stands()) ++captions_left_out_;
    captions_.pop_front();
  }
}

}  // namespace aucast::protocol
