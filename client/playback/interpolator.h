#pragma once

#include <cstdint>
#include <span>

namespace aucast::playback {

enum class Interpolation : std::uint8_t {
  Linear,
  Cosine,  ///< (1 - cos(pi mu)) / 2 (thesis 2.4.1.2)
};

/// The weight of the end at fraction `mu` in [0,1]: exactly 0 at 0 and 1 at 1.
[[nodiscard]] float ease(Interpolation kind, double mu);

/// out = start (1 - w) + end w for each activation. At w = 0 and w = 1, `out` equals `start` and
/// `end` bit for bit. All spans have the same size; `out` may be `start` or `end`.
void interpolate(std::span<const float> start, std::span<const float> end, float weight,
                 std::span<float> out);

}  // namespace aucast::playback
