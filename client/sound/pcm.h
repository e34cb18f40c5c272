#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace aucast::sound {

/// What a sample of 1 is in 16 bits.
inline constexpr float kPcmWhole = 32767;

/// Samples in [-1, 1] in 16 bits; what is louder is clipped.
[[nodiscard]] inline std::vector<std::int16_t> pcm_of(std::span<const float> samples) {
  std::vector<std::int16_t> pcm;
  pcm.reserve(samples.size());
  for (const float sample : samples) {
    const float clipped = std::clamp(sample, -1.0F, 1.0F);
    pcm.push_back(static_cast<std::int16_t>(std::lround(clipped * kPcmWhole)));
  }
  return pcm;
}

}  // namespace aucast::sound
