#include "client/playback/interpolator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/check.h"

namespace aucast::playback {

float ease(Interpolation kind, double mu) {
  if (mu <= 0) return 0;
  if (mu >= 1) return 1;
  if (kind == Interpolation::Linear) return static_cast<float>(mu);
  return static_cast<float>((1 - std::cos(std::numbers::pi * mu)) / 2);
}

void interpolate(std::span<const float> start, std::span<const float> end, float weight,
                 std::span<float> out) {
  AUCAST_CHECK(start.size() == out.size());
  AUCAST_CHECK(end.size() == out.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const float from = start[i];
    const float to = end[i];
    // Rounding could step outside the two keys by a bit, and move what does not change.
    const auto [low, high] = std::minmax({from, to});
    out[i] = std::clamp(from * (1 - weight) + to * weight, low, high);
  }
}

}  // namespace aucast::playback
