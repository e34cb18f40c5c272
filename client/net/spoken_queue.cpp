#include "client/net/spoken_queue.h"

#include <utility>

#include "protocol/voice_packet.h"

namespace aucast::net {
namespace {

template <typename T>
std::optional<T> front_of(std::deque<T>& queue) {
  if (queue.empty()) return std::nullopt;
  T front = std::move(queue.front());
  queue.pop_front();
  return front;
}

}  // namespace

void SpokenQueue::add(playback::Voice voice) {
  if (voice_.size() == playback::kVoicePacketsMax ||
      voice_bytes_ + voice.opus.size() > playback::kVoiceBytesMax) {
    ++voice_left_out_;
    return;
  }
  voice_end_ = voice.place + protocol::opus_duration(voice.opus).value_or(Milliseconds::zero());
  voice_bytes_ += voice.opus.size();
  voice_.push_back(std::move(voice));
}

void SpokenQueue::add(playback::Caption caption) {
  if (captions_.size() == kCaptionsMax) {
    ++captions_left_out_;
    return;
  }
  captions_.push_back(std::move(caption));
}

std::optional<playback::Voice> SpokenQueue::take_voice() {
  auto voice = front_of(voice_);
  if (voice) voice_bytes_ -= voice->opus.size();
  return voice;
}

std::optional<playback::Caption> SpokenQueue::take_caption() {
  return front_of(captions_);
}

}  // namespace aucast::net
