#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace aucast {

/// 0 to 1 as a byte of a picture, 0 to 255; clamped and rounded.
[[nodiscard]] inline std::uint8_t byte_of_share(float share) {
  return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(share, 0.0F, 1.0F)));
}

// sRGB (IEC 61966-2-1) to linear light and back.

[[nodiscard]] inline float linear_of_srgb(std::uint8_t byte) {
  const float value = static_cast<float>(byte) / 255.0F;
  return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
}

[[nodiscard]] inline std::uint8_t srgb_of_linear(float linear) {
  const float light = std::clamp(linear, 0.0F, 1.0F);
  return byte_of_share(light <= 0.0031308F ? 12.92F * light
                                           : 1.055F * std::pow(light, 1 / 2.4F) - 0.055F);
}

}  // namespace aucast
