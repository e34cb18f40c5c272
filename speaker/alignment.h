#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "speaker/speech.h"

namespace aucast::speaker {

/// Which windows of two sounds belong together: pairs of their numbers, one of each sound. Neither
/// number decreases from pair to pair.
using AlignmentPath = std::vector<std::pair<std::size_t, std::size_t>>;

/// A description of a sound by which voices can be compared: its mel-frequency cepstrum, window
/// by window.
struct Cepstrum {
  static constexpr std::size_t kCoefficients = 13;
  static constexpr Milliseconds kHop{10};

  /// One row of kCoefficients for each window; each coefficient is normalised to mean 0 and
  /// standard deviation 1 over the whole sound.
  std::vector<float> rows;

  [[nodiscard]] std::size_t windows() const { return rows.size() / kCoefficients; }
};

/// The cepstrum of mono samples in [-1,1], at `rate` samples a second; a window of 32 ms every
/// kHop.
[[nodiscard]] Cepstrum cepstrum_of(std::span<const float> samples, int rate);

/// The cheapest path through both (dynamic time warping), from both beginnings to both ends. A
/// coarse path is found first, then refined near itself, so that memory grows with the length and
/// not with its square.
[[nodiscard]] AlignmentPath align(const Cepstrum& a, const Cepstrum& b);

/// A narration in the form of a synthesiser's speech.
struct CarriedOver {
  Speech speech;
  /// The correlation of both sounds' loudness along the path: 1 for the same sound, above 0.3 for a
  /// reading of the text, near 0 for what is none.
  float likeness = 0;
};

/// Moves a synthesiser's speech onto a narration of the same words; the narration is mono, at
/// `rate`. Returns the phonemes, words and clause ends of `synthesised` at the times at which they
/// come in the narration, and the narration as the samples.
[[nodiscard]] CarriedOver carried_over(const Speech& synthesised, std::vector<float> narration,
                                       int rate);

}  // namespace aucast::speaker
