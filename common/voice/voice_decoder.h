#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

struct OpusDecoder;

namespace aucast::voice {

/// Samples a second of decoded sound, which is mono; sound systems play this rate without
/// resampling.
inline constexpr int kDecoderRate = 48000;
inline constexpr int kDecoderSamplesPerMs = kDecoderRate / 1000;

/// Turns Opus packets into samples. Thread: none of its own.
class VoiceDecoder {
 public:
  VoiceDecoder();
  ~VoiceDecoder();
  VoiceDecoder(VoiceDecoder&&) noexcept;
  VoiceDecoder& operator=(VoiceDecoder&&) noexcept;

  /// The sound of the packet, mono at kDecoderRate, in [-1,1]; valid until the next call. Empty for
  /// bytes that are no Opus packet.
  [[nodiscard]] std::span<const float> decode(std::string_view opus);
  /// 20 ms of a plausible continuation, for a packet that is missing.
  [[nodiscard]] std::span<const float> conceal();

 private:
  struct Destroy {
    void operator()(OpusDecoder* decoder) const;
  };

  std::unique_ptr<OpusDecoder, Destroy> decoder_;
  std::vector<float> samples_;
};

}  // namespace aucast::voice
