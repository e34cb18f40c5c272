#pragma once

#include <cstdint>
#include <span>

#include "common/voice/voice_decoder.h"

namespace aucast::sound {

/// Samples a second of everything here, mono.
inline constexpr int kRate = voice::kDecoderRate;
inline constexpr int kSamplesPerMs = voice::kDecoderSamplesPerMs;

/// The sound that lies along a stream, mono at kRate in [-1,1]. Its samples are counted from the
/// stream's beginning.
class SoundTrack {
 public:
  SoundTrack() = default;
  virtual ~SoundTrack() = default;
  SoundTrack(const SoundTrack&) = delete;
  SoundTrack& operator=(const SoundTrack&) = delete;

  /// Fills `samples` with the sound from sample `begin` on; silence where there is none.
  virtual void read(std::int64_t begin, std::span<float> samples) = 0;
  /// Behind the last sample that is known.
  [[nodiscard]] virtual std::int64_t end() const = 0;
};

}  // namespace aucast::sound
