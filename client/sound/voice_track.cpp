#include "client/sound/voice_track.h"

#include <algorithm>
#include <utility>

#include "client/playback/keyframe_source.h"
#include "protocol/limits.h"
#include "protocol/voice_packet.h"

namespace aucast::sound {
namespace {

constexpr std::int64_t kFadeIn = std::int64_t{5} * kSamplesPerMs;
/// Leaps longer than this are skipped rather than decoded.
constexpr std::int64_t kVoiceLeap = std::int64_t{500} * kSamplesPerMs;
/// A decoder that begins in the middle of a stream is exact after five packets of 60 ms.
constexpr std::int64_t kRunUp = std::int64_t{300} * kSamplesPerMs;

}  // namespace

VoiceTrack::Counts& VoiceTrack::Counts::operator+=(const Counts& more) {
  packets += more.packets;
  bytes += more.bytes;
  gaps += more.gaps;
  too_late += more.too_late;
  left_out += more.left_out;
  out_of_order += more.out_of_order;
  unreadable += more.unreadable;
  return *this;
}

void VoiceTrack::add(Milliseconds place, std::string opus) {
  ++counts_.packets;
  counts_.bytes += opus.size();
  const auto duration = protocol::opus_duration(opus);
  if (!duration) {
    ++counts_.unreadable;
    return;
  }
  const std::int64_t begin = place.count() * kSamplesPerMs;
  const std::int64_t end = begin + duration->count() * kSamplesPerMs;
  if (!waiting_.empty() && begin < waiting_.back().end) {
    ++counts_.out_of_order;
    return;
  }
  if (waiting_.size() == playback::kVoicePacketsMax ||
      waiting_bytes_ + opus.size() > playback::kVoiceBytesMax) {
    ++counts_.left_out;
    return;
  }
  waiting_bytes_ += opus.size();
  last_end_ = std::max(last_end_, end);
  waiting_.push_back({begin, end, std::move(opus)});
}

void VoiceTrack::read(std::int64_t begin, std::span<float> samples) {
  const auto count = static_cast<std::int64_t>(samples.size());
  skip(begin);
  decode_until(begin + count);
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t at = begin + i - begin_;
    samples[static_cast<std::size_t>(i)] = at < 0 ? 0 : decoded_[static_cast<std::size_t>(at)];
  }
  forget_before(begin + count - kKept.count() * kSamplesPerMs);
}

std::int64_t VoiceTrack::decoded_end() const {
  return begin_ + static_cast<std::int64_t>(decoded_.size());
}

void VoiceTrack::skip(std::int64_t begin) {
  if (begin <= decoded_end() + kVoiceLeap) return;
  decoded_.clear();
  begin_ = begin - kRunUp;
  silent_ = true;
  while (!waiting_.empty() && waiting_.front().end <= begin_) drop_front();
}

void VoiceTrack::end_at(std::int64_t end) {
  const std::int64_t last = end + protocol::kVoiceAheadMax.count() * kSamplesPerMs;
  while (!waiting_.empty() && waiting_.back().end > last) {
    waiting_bytes_ -= waiting_.back().opus.size();
    waiting_.pop_back();
    ++counts_.left_out;
    last_end_ = waiting_.empty() ? decoded_end() : waiting_.back().end;
  }
}

void VoiceTrack::decode_until(std::int64_t end) {
  while (decoded_end() < end) {
    if (!waiting_.empty() && waiting_.front().begin <= decoded_end()) {
      append(waiting_.front());
      drop_front();
      continue;
    }
    const std::int64_t next = waiting_.empty() ? end : waiting_.front().begin;
    if (silent_) {
      decoded_.resize(static_cast<std::size_t>(std::min(next, end) - begin_));
    } else {
      fade_out(waiting_.empty() ? decoded_end() + kVoiceLeap : next);
    }
  }
}

/// The part of the packet before decoded_end() is left out: silence has been heard there already.
void VoiceTrack::append(const Packet& packet) {
  const std::span<const float> sound = decoder_.decode(packet.opus);
  if (sound.empty()) {
    ++counts_.unreadable;
    return;
  }
  const std::int64_t from = decoded_end();
  const std::int64_t heard = from - packet.begin;
  if (heard >= static_cast<std::int64_t>(sound.size())) {
    ++counts_.too_late;
    return;
  }
  decoded_.insert(decoded_.end(), sound.begin() + static_cast<std::ptrdiff_t>(heard), sound.end());
  if (std::exchange(silent_, false)) {
    const std::int64_t fade = std::min(kFadeIn, decoded_end() - from);
    for (std::int64_t i = 0; i < fade; ++i) {
      decoded_[static_cast<std::size_t>(from - begin_ + i)] *=
          static_cast<float>(i) / static_cast<float>(fade);
    }
  }
}

/// Continues the voice by concealment, ever softer, up to `until` at most.
void VoiceTrack::fade_out(std::int64_t until) {
  const std::span<const float> sound = decoder_.conceal();
  const auto fade = std::min(static_cast<std::int64_t>(sound.size()), until - decoded_end());
  for (std::int64_t i = 0; i < fade; ++i) {
    const float weight = static_cast<float>(fade - i) / static_cast<float>(fade + 1);
    decoded_.push_back(sound[static_cast<std::size_t>(i)] * weight);
  }
  silent_ = true;
  ++counts_.gaps;
}

void VoiceTrack::forget_before(std::int64_t begin) {
  // Not at each call: what follows is moved.
  if (begin - begin_ < kVoiceLeap) return;
  decoded_.erase(decoded_.begin(), decoded_.begin() + static_cast<std::ptrdiff_t>(begin - begin_));
  begin_ = begin;
}

void VoiceTrack::drop_front() {
  waiting_bytes_ -= waiting_.front().opus.size();
  waiting_.pop_front();
}

}  // namespace aucast::sound
