// In a page, npm's opus-decoder in place of libopus: Module.voice, which the page's
// voice_decoders.js makes.
#include <emscripten.h>

#include <cstddef>
#include <cstdint>

#include "common/voice/voice_decoder.h"

// clang-format off
EM_JS(std::uint32_t, aucast_js_open_decoder, (), { return Module.voice.open(); });
EM_JS(void, aucast_js_close_decoder, (std::uint32_t decoder), { Module.voice.close(decoder); });
// No bytes: what the sound could have gone on like.
EM_JS(std::size_t, aucast_js_decode,
      (std::uint32_t decoder, const char* bytes, std::size_t count, float* samples,
       std::size_t most), {
  const sound = Module.voice.decode(decoder, HEAPU8.slice(bytes, bytes + count)).subarray(0, most);
  HEAPF32.set(sound, samples >> 2);
  return sound.length;
});
// clang-format on

struct OpusDecoder {
  std::uint32_t number = aucast_js_open_decoder();
};

namespace aucast::voice {
namespace {

constexpr std::size_t kPacketSamplesMax = std::size_t{120} * kDecoderSamplesPerMs;
constexpr std::size_t kConcealedSamples = std::size_t{20} * kDecoderSamplesPerMs;

}  // namespace

void VoiceDecoder::Destroy::operator()(OpusDecoder* decoder) const {
  aucast_js_close_decoder(decoder->number);
  delete decoder;
}

VoiceDecoder::VoiceDecoder() : decoder_(new OpusDecoder), samples_(kPacketSamplesMax) {}
VoiceDecoder::~VoiceDecoder() = default;
VoiceDecoder::VoiceDecoder(VoiceDecoder&&) noexcept = default;
VoiceDecoder& VoiceDecoder::operator=(VoiceDecoder&&) noexcept = default;

std::span<const float> VoiceDecoder::decode(std::string_view opus) {
  if (opus.empty()) return {};
  return {samples_.data(), aucast_js_decode(decoder_->number, opus.data(), opus.size(),
                                            samples_.data(), kPacketSamplesMax)};
}

std::span<const float> VoiceDecoder::conceal() {
  return {samples_.data(),
          aucast_js_decode(decoder_->number, nullptr, 0, samples_.data(), kConcealedSamples)};
}

}  // namespace aucast::voice
