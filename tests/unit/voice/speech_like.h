#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "common/voice/voice_encoder.h"

namespace aucast::voice::test {

/// A voiced sound at kEncoderRate: a falling and rising pitch with overtones, in syllables of a
/// quarter of a second.
inline std::vector<float> speech_like(double seconds, int rate = kEncoderRate) {
  std::vector<float> samples(static_cast<std::size_t>(seconds * rate));
  double phase = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = static_cast<double>(i) / rate;
    phase += 2 * std::numbers::pi * (140 + 30 * std::sin(2 * t)) / rate;
    double sum = 0;
    for (int overtone = 1; overtone <= 12; ++overtone) sum += std::sin(overtone * phase) / overtone;
    const double syllable = std::sin(std::numbers::pi * std::fmod(t, 0.25) / 0.25);
    samples[i] = static_cast<float>(0.15 * sum * syllable);
  }
  return samples;
}

/// Correlation of two signals, the second one shifted by `lag` samples.
inline double correlation(const std::vector<float>& a, const std::vector<float>& b, int lag) {
  double ab = 0;
  double aa = 0;
  double bb = 0;
  for (std::size_t i = 2000; i + 2000 < a.size() && i + 2000 < b.size(); ++i) {
    const double x = static_cast<double>(a[i]);
    const double y = static_cast<double>(b[static_cast<std::size_t>(static_cast<int>(i) + lag)]);
    ab += x * y;
    aa += x * x;
    bb += y * y;
  }
  return ab / std::sqrt(aa * bb);
}

}  // namespace aucast::voice::test
