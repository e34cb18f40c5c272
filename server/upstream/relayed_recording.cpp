#include "server/upstream/relayed_recording.h"

#include <algorithm>
#include <utility>

#include "server/settings/limits.h"

namespace aucast::server {
namespace {

using protocol::Extent;

/// After how many pieces the free memory is checked again.
constexpr std::size_t kKeptBetweenLooks = 4096;

bool is_before(const protocol::CaptionData& one, const protocol::CaptionData& other) {
  return one.place_ms < other.place_ms;
}

}  // namespace

RelayedRecording::RelayedRecording(const protocol::HelloGranted& hello, MayHold may_hold)
    : may_hold_(std::move(may_hold)), changes_(hello.delta) {
  encoded_->duration_ms = hello.duration_ms;
  encoded_->extent = Extent::Growing;
  if (hello.voice == protocol::kVoiceCodec) voice_ = std::make_shared<protocol::EncodedTrack>();
  if (!voice_ && !hello.text) return;
  spoken_ = std::make_shared<protocol::SpokenTrack>();
  spoken_->voice = voice_;
  spoken_->captions_come = hello.text;
}

void RelayedRecording::go_on() {
  if (!whole()) encoded_->extent = Extent::Growing;
  const auto takes_time = [](protocol::KeyframeTime time) { return time.count() > 0; };
  const auto& times = encoded_->times;
  const auto last = std::find_if(times.rbegin(), times.rend(), takes_time);
  keyframes_again_ = static_cast<std::size_t>(last - times.rbegin());
  caption_again_ = 0;
}

std::optional<std::string> RelayedRecording::add(const protocol::EncodedKeyframe& keyframe,
                                                 std::uint32_t time_ms) {
  if (time_ms == 0 && keyframes_again_ > 0) {
    --keyframes_again_;
    return std::nullopt;
  }
  if (place_ms_ + time_ms > duration_ms()) {
    return "it sends more than the " + std::to_string(duration_ms()) + " ms that it announced";
  }
  if (auto full = no_room()) return full;
  keyframes_again_ = 0;
  encoded_->classic.push_back(keyframe.classic);
  encoded_->negotiated.push_back(keyframe.full);
  if (changes_) encoded_->changes.push_back(keyframe.changes);
  encoded_->times.emplace_back(time_ms);
  place_ms_ += time_ms;
  if (voice_) voice_->encoded_to(Milliseconds(place_ms_));
  return std::nullopt;
}

std::optional<std::string> RelayedRecording::add(const protocol::VoicePacket& voice) {
  if (!voice_) return std::nullopt;
  if (auto full = no_room()) return full;
  const auto before = voice_->packets();
  if (before.empty() || voice.place >= before.back().end) voice_->add(voice);
  return std::nullopt;
}

std::optional<std::string> RelayedRecording::add(const protocol::CaptionData& caption) {
  if (!spoken_) return std::nullopt;
  if (auto full = no_room()) return full;
  auto& captions = spoken_->captions;
  const auto again = captions.begin() + static_cast<std::ptrdiff_t>(caption_again_);
  const auto [first, end] = std::equal_range(again, captions.end(), caption, is_before);
  if (const auto here = std::find(first, end, caption); here != end) {
    caption_again_ = static_cast<std::size_t>(here - captions.begin()) + 1;
    return std::nullopt;
  }
  if (!captions.empty() && is_before(caption, captions.back())) return std::nullopt;
  captions.push_back(caption);
  caption_again_ = captions.size();
  caption_bytes_ += sizeof(protocol::CaptionData) + caption.text.size();
  return std::nullopt;
}

/// Called before more is kept.
std::optional<std::string> RelayedRecording::no_room() {
  const std::uint64_t bytes =
      held_bytes(*encoded_) + (voice_ ? voice_->bytes() : 0) + caption_bytes_;
  if (bytes > kRelayedBytesMax) {
    return "its stream has more than " + std::to_string(kRelayedBytesMax >> 30U) + " GiB";
  }
  if (looks_ % kKeptBetweenLooks == 0) {
    // As much again is taken for a moment when the buffers grow.
    if (const auto may = may_hold_(bytes); !may) return may.error().message;
  }
  ++looks_;
  return std::nullopt;
}

std::optional<std::string> RelayedRecording::end() {
  if (place_ms_ < duration_ms()) {
    return "it ended after " + std::to_string(place_ms_) + " ms of the " +
           std::to_string(duration_ms()) + " ms that it announced";
  }
  encoded_->extent = Extent::Whole;
  if (voice_) voice_->finish();
  return std::nullopt;
}

void RelayedRecording::break_off() {
  if (!whole()) encoded_->extent = Extent::BrokenOff;
}

}  // namespace aucast::server
