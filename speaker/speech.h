#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "common/time.h"

namespace aucast::speaker {

/// A speech sound, from `begin` to the next one's. `ipa` is empty for a pause.
struct Phoneme {
  std::string ipa;
  Milliseconds begin{0};
};

/// A word of the text, where it is heard and where it stands.
struct Word {
  Milliseconds begin{0};
  std::size_t at = 0;      ///< characters (not bytes) of the text before it
  std::size_t length = 0;  ///< in characters
};

/// A text as it is heard.
struct Speech {
  int rate = 22050;            ///< samples a second
  std::vector<float> samples;  ///< mono, in [-1,1]
  std::vector<Phoneme> phonemes;
  std::vector<Word> words;
  std::vector<Milliseconds> sentence_ends;

  [[nodiscard]] Milliseconds length() const {
    return Milliseconds(samples.size() * 1000 / static_cast<std::size_t>(rate));
  }
};

}  // namespace aucast::speaker
