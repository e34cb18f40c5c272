#include "common/voice/voice_encoder.h"

#include <opus.h>

#include <algorithm>
#include <array>
#include <string>

#include "common/check.h"

namespace aucast::voice {
namespace {

/// -52 dBFS: below a quiet voice in a quiet room, above a sound card's own noise.
constexpr float kSilenceRms = 0.0025F;
/// Speech has pauses of its own (closures of stops) that are no silence.
constexpr Milliseconds kHangover{240};
constexpr std::size_t kBlockSamples = 10 * kEncoderSamplesPerMs;
constexpr std::size_t kPacketBytesMax = 1275;

std::size_t samples_in(Milliseconds time) {
  return static_cast<std::size_t>(time.count()) * kEncoderSamplesPerMs;
}

/// Whether any block of a frame is loud enough to be heard.
bool sounds(std::span<const float> samples) {
  for (; !samples.empty(); samples = samples.subspan(kBlockSamples)) {
    float energy = 0;
    for (const float sample : samples.first(kBlockSamples)) energy += sample * sample;
    if (energy > kSilenceRms * kSilenceRms * static_cast<float>(kBlockSamples)) return true;
  }
  return false;
}

}  // namespace

void VoiceEncoder::Destroy::operator()(OpusEncoder* encoder) const {
  opus_encoder_destroy(encoder);
}

VoiceEncoder::~VoiceEncoder() = default;
VoiceEncoder::VoiceEncoder(VoiceEncoder&&) noexcept = default;
VoiceEncoder& VoiceEncoder::operator=(VoiceEncoder&&) noexcept = default;

VoiceEncoder::VoiceEncoder(const VoiceSettings& settings, Milliseconds begin)
    : frame_(settings.frame), place_(begin), silent_(kHangover) {
  int error = OPUS_OK;
  encoder_.reset(opus_encoder_create(kEncoderRate, 1, OPUS_APPLICATION_VOIP, &error));
  AUCAST_CHECK(error == OPUS_OK);
  OpusEncoder* const encoder = encoder_.get();
  opus_encoder_ctl(encoder, OPUS_SET_BITRATE(settings.bits_per_second));
  opus_encoder_ctl(encoder, OPUS_SET_VBR(1));
  opus_encoder_ctl(encoder, OPUS_SET_VBR_CONSTRAINT(1));
  opus_encoder_ctl(encoder, OPUS_SET_SIGNAL(OPUS_SIGNAL_VOICE));
  // Below some 9 kbit/s the codec would go narrow-band by itself.
  opus_encoder_ctl(encoder, OPUS_SET_BANDWIDTH(OPUS_BANDWIDTH_WIDEBAND));
  opus_encoder_ctl(encoder, OPUS_SET_COMPLEXITY(10));
  // TCP loses nothing, so nothing is sent twice; silence is left out here, sooner than by DTX.
  opus_encoder_ctl(encoder, OPUS_SET_INBAND_FEC(0));
  opus_encoder_ctl(encoder, OPUS_SET_DTX(0));
  opus_int32 lookahead = 0;
  opus_encoder_ctl(encoder, OPUS_GET_LOOKAHEAD(&lookahead));
  // A decoder to 48 kHz gives its samples two thirds of ours sooner than one to our rate.
  lookahead_ = static_cast<std::size_t>(lookahead) - 1;
}

void VoiceEncoder::add(std::span<const float> samples,
                       std::vector<protocol::VoicePacket>& packets) {
  const std::size_t skip = std::min(lookahead_ - skipped_, samples.size());
  skipped_ += skip;
  pending_.insert(pending_.end(), samples.begin() + static_cast<std::ptrdiff_t>(skip),
                  samples.end());
  encode_frames(packets);
}

void VoiceEncoder::finish(std::vector<protocol::VoicePacket>& packets) {
  // The codec still holds the last samples back.
  const std::size_t rest = pending_.size() + skipped_;
  if (rest == 0) return;
  const std::size_t frame = samples_in(frame_);
  pending_.resize((rest + frame - 1) / frame * frame, 0.0F);
  // Silent or not: who hears it knows by the last packet how long the sound is.
  silent_ = Milliseconds::zero();
  encode_frames(packets);
  skipped_ = 0;
}

void VoiceEncoder::go_on_at(Milliseconds place) {
  AUCAST_CHECK(place >= place_);
  pending_.clear();
  skipped_ = 0;
  place_ = place;
  silent_ = kHangover;
}

Milliseconds VoiceEncoder::end() const {
  return place_ + Milliseconds((pending_.size() + skipped_) / kEncoderSamplesPerMs);
}

/// All whole frames, taken off what is pending at once: frame by frame a long file would be moved
/// as often as it has frames.
void VoiceEncoder::encode_frames(std::vector<protocol::VoicePacket>& packets) {
  const std::size_t frame = samples_in(frame_);
  std::size_t done = 0;
  for (; done + frame <= pending_.size(); done += frame) {
    encode_frame(std::span(pending_).subspan(done, frame), packets);
  }
  pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(done));
}

void VoiceEncoder::encode_frame(std::span<const float> samples,
                                std::vector<protocol::VoicePacket>& packets) {
  silent_ = sounds(samples) ? Milliseconds{0} : std::min(silent_ + frame_, kHangover);
  if (silent_ < kHangover) {
    std::array<unsigned char, kPacketBytesMax> bytes{};
    const int length =
        opus_encode_float(encoder_.get(), samples.data(), static_cast<int>(samples.size()),
                          bytes.data(), static_cast<opus_int32>(bytes.size()));
    AUCAST_CHECK(length > 0);
    packets.push_back({place_, std::string(bytes.begin(), bytes.begin() + length)});
  }
  place_ += frame_;
}

}  // namespace aucast::voice
