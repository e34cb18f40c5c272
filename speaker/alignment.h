#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "speaker/speech.h"

namespace aucast::speaker {

/// Pairs of frames of two sounds that belong together. Neither number ever decreases.
using AlignmentPath = std::vector<std::pair<std::size_t, std::size_t>>;

/// A description of a sound by which voices can be compared: its mel-frequency cepstrum, frame by
/// frame.
struct Cepstrum {
  static constexpr std::size_t kCoefficients = 13;
  static constexpr Milliseconds kHop{10};

  /// One row of kCoefficients for each frame; each coefficient is normalised to mean 0 and standard
  /// deviation 1 over the whole sound.
  std::vector<float> rows;

  [[nodiscard]] std::size_t frames() const { return rows.size() / kCoefficients; }
};

/// The cepstrum of mono samples in [-1,1], at `rate` samples a second; a frame of 32 ms every kHop.
[[nodiscard]] Cepstrum cepstrum_of(std::span<const float> samples, int rate);

/// The cheapest path through both (dynamic time warping), from both beginnings to both ends. It is
/// found coarsely first, then refined near that, so that memory grows with the length and not with
/// its square.
[[nodiscard]] AlignmentPath align(const Cepstrum& a, const Cepstrum& b);

/// Moves a synthesiser's speech onto a narration of the same words, mono at `rate`: returns its
/// phonemes, words and sentence ends at the times at which the narration has them, with the
/// narration as its samples.
[[nodiscard]] Speech carried_over(const Speech& spoken, std::vector<float> narration, int rate);

}  // namespace aucast::speaker
