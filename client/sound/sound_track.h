#pragma once

#include <chrono>
#include <cstdint>
#include <span>

#include "common/time.h"
#include "common/voice/voice_decoder.h"

namespace aucast::sound {

/// Samples a second of all sound in this folder. All of it is mono.
inline constexpr int kRate = voice::kDecoderRate;
inline constexpr int kSamplesPerMs = voice::kDecoderSamplesPerMs;

/// How long so many samples last.
[[nodiscard]] constexpr Duration time_of(std::int64_t samples) {
  return Milliseconds(samples / kSamplesPerMs) +
         std::chrono::nanoseconds(samples % kSamplesPerMs * 1'000'000 / kSamplesPerMs);
}
/// How many whole samples there are in a time.
[[nodiscard]] constexpr std::int64_t samples_of(Duration time) {
  return time / Milliseconds(1) * kSamplesPerMs +
         time % Milliseconds(1) * kSamplesPerMs / Milliseconds(1);
}

/// The sound of a stream, mono at kRate in [-1,1]. Its samples are counted from the stream's
/// beginning.
class SoundTrack {
 public:
  SoundTrack() = default;
  virtual ~SoundTrack() = default;
  SoundTrack(const SoundTrack&) = delete;
  SoundTrack& operator=(const SoundTrack&) = delete;

  /// Fills `samples` with the sound from sample `begin` on; silence where there is none.
  virtual void read(std::int64_t begin, std::span<float> samples) = 0;
  /// The number of the last known sample plus one.
  [[nodiscard]] virtual std::int64_t end() const = 0;
};

}  // namespace aucast::sound
