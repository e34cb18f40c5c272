#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "speaker/speech.h"

namespace aucast::speaker {

/// Pairs of frames that belong together, both ascending, from the first pair to the last.
using AlignmentPath = std::vector<std::pair<std::size_t, std::size_t>>;

/// What a moment of sound is like, for comparing voices: mel-frequency cepstrum.
struct Cepstrum {
  static constexpr std::size_t kCoefficients = 13;
  static constexpr Milliseconds kHop{10};

  /// Row by row, kCoefficients each, normalised to mean 0 and deviation 1 over the whole sound.
  std::vector<float> rows;

  [[nodiscard]] std::size_t frames() const { return rows.size() / kCoefficients; }
};

/// Of mono samples in [-1,1]; a frame every kHop, of 32 ms.
[[nodiscard]] Cepstrum cepstrum_of(std::span<const float> samples, int rate);

/// The cheapest way through both (dynamic time warping), from both beginnings to both ends. Found
/// coarsely first and then near that, so that memory grows with the length and not with its square.
[[nodiscard]] AlignmentPath align(const Cepstrum& a, const Cepstrum& b);

/// The speech of a synthesiser carried over to a recording of the same words: its phonemes, words
/// and sentences at the moments at which the recording has them; `recording` becomes its samples.
[[nodiscard]] Speech carried_over(const Speech& spoken, std::vector<float> recording, int rate);

}  // namespace aucast::speaker
