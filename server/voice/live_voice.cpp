#include "server/voice/live_voice.h"

#include <algorithm>
#include <span>

#include "common/time.h"

namespace aucast::server {
namespace {

/// How far the sound may be from its place while somebody speaks, ...
constexpr Milliseconds kOffMax{80};
/// ... and in a pause, which is a silence of at least kPause.
constexpr Milliseconds kOffInPause{5};
constexpr Milliseconds kPause{120};
/// A hole of at least this length is left open; a shorter one is filled with silence.
constexpr Milliseconds kHole{1000};

}  // namespace

LiveVoice::LiveVoice(const voice::VoiceSettings& settings, Milliseconds delay)
    : encoder_(settings), delay_(delay) {}

void LiveVoice::add_keyframe(Milliseconds end, SteadyTime now) {
  face_.add(now, end);
}

std::vector<protocol::VoicePacket> LiveVoice::end_sound() {
  std::vector<protocol::VoicePacket> packets;
  encoder_.finish(packets);
  sound_.forget();
  samples_ = 0;
  half_.clear();
  placed_ = false;
  return packets;
}

std::vector<float> LiveVoice::samples_of(std::string_view bytes) {
  std::string all = half_;
  all += bytes;
  std::vector<float> samples(all.size() / 2);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto low = static_cast<unsigned char>(all[2 * i]);
    const auto high = static_cast<signed char>(all[2 * i + 1]);
    samples[i] = static_cast<float>(high * 256 + low) / 32768.0F;
  }
  half_ = all.substr(samples.size() * 2);
  return samples;
}

/// Moves the encoder to `target`, where the next `count` samples belong. Returns how many of them
/// are to be left out for that.
std::size_t LiveVoice::steer(Milliseconds target, std::size_t count,
                             std::vector<protocol::VoicePacket>& packets) {
  const Milliseconds off = target - encoder_.end();
  const Milliseconds most = silent_ >= kPause ? kOffInPause : kOffMax;
  const auto samples = [](Milliseconds time) {
    return static_cast<std::size_t>(time.count()) * voice::kEncoderSamplesPerMs;
  };
  if (placed_ && off <= most && -off <= most) return 0;
  if (off < Milliseconds::zero()) {
    placed_ = samples(-off) <= count;
    return std::min(samples(-off), count);
  }
  if (placed_ && off < kHole) {
    encoder_.add(std::vector<float>(samples(off)), packets);
  } else if (off > Milliseconds::zero()) {
    encoder_.go_on_at(target);
  }
  placed_ = true;
  return 0;
}

std::vector<protocol::VoicePacket> LiveVoice::add(std::string_view bytes, SteadyTime now) {
  std::vector<protocol::VoicePacket> packets;
  const std::vector<float> samples = samples_of(bytes);
  const auto made = [this] { return Seconds(static_cast<double>(samples_) / voice::kEncoderRate); };
  const Seconds before = made();
  samples_ += samples.size();
  sound_.add(now, made());
  if (!face_.known()) return packets;
  const double place = seconds(sound_.begin() + before - face_.begin());
  const Milliseconds target = Milliseconds(whole_milliseconds(place)) + delay_;
  const std::size_t left_out = steer(target, samples.size(), packets);
  encoder_.add(std::span(samples).subspan(left_out), packets);
  const Milliseconds length(samples.size() / voice::kEncoderSamplesPerMs);
  silent_ = packets.empty() ? silent_ + length : Milliseconds::zero();
  return packets;
}

}  // namespace aucast::server
