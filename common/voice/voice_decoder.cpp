#include "common/voice/voice_decoder.h"

#include <opus.h>

#include <cstddef>

#include "common/check.h"

namespace aucast::voice {
namespace {

constexpr int kPacketSamplesMax = 120 * kDecoderSamplesPerMs;
constexpr int kConcealedSamples = 20 * kDecoderSamplesPerMs;

}  // namespace

void VoiceDecoder::Destroy::operator()(OpusDecoder* decoder) const {
  opus_decoder_destroy(decoder);
}

VoiceDecoder::~VoiceDecoder() = default;
VoiceDecoder::VoiceDecoder(VoiceDecoder&&) noexcept = default;
VoiceDecoder& VoiceDecoder::operator=(VoiceDecoder&&) noexcept = default;

VoiceDecoder::VoiceDecoder() : samples_(kPacketSamplesMax) {
  int error = OPUS_OK;
  decoder_.reset(opus_decoder_create(kDecoderRate, 1, &error));
  AUCAST_CHECK(error == OPUS_OK);
}

std::span<const float> VoiceDecoder::decode(std::string_view opus) {
  // With no bytes libopus would conceal.
  if (opus.empty()) return {};
  const int count = opus_decode_float(
      decoder_.get(), reinterpret_cast<const unsigned char*>(opus.data()),
      static_cast<opus_int32>(opus.size()), samples_.data(), kPacketSamplesMax, 0);
  if (count < 0) return {};
  return {samples_.data(), static_cast<std::size_t>(count)};
}

std::span<const float> VoiceDecoder::conceal() {
  const int count =
      opus_decode_float(decoder_.get(), nullptr, 0, samples_.data(), kConcealedSamples, 0);
  if (count < 0) return {};
  return {samples_.data(), static_cast<std::size_t>(count)};
}

}  // namespace aucast::voice
