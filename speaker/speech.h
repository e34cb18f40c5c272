#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

#include "common/time.h"

namespace aucast::speaker {

/// The longest speech, made or narrated. It is held in memory: of each hour 320 MB of what is made,
/// 230 MB of a narration.
inline constexpr Milliseconds kSpeechMax = std::chrono::hours(3);

/// A speech sound, which lasts until the next one begins. `ipa` is empty for a pause.
struct Phoneme {
  std::string ipa;
  Milliseconds begin{0};
};

/// A word of the text: when it is heard, and where it is in the text.
struct Word {
  Milliseconds begin{0};
  std::size_t at = 0;      ///< how many characters (not bytes) of the text come before it
  std::size_t length = 0;  ///< in characters
};

/// A text that was spoken.
struct Speech {
  int rate = 22050;               ///< samples a second
  std::vector<float> samples;     ///< mono, in [-1,1]
  std::vector<Phoneme> phonemes;  ///< no two pauses in a row
  std::vector<Word> words;
  std::vector<Milliseconds> clause_ends;  ///< of sentences, and before commas and the like

  [[nodiscard]] Milliseconds length() const {
    return Milliseconds(samples.size() * 1000 / static_cast<std::size_t>(rate));
  }
  /// When the next phoneme begins; after the last one, the end of the speech.
  [[nodiscard]] Milliseconds phoneme_end(std::size_t i) const {
    return i + 1 < phonemes.size() ? phonemes[i + 1].begin : length();
  }
  /// When word `i` begins; beyond the last one, the end of the speech.
  [[nodiscard]] Milliseconds word_begin(std::size_t i) const {
    return i < words.size() ? words[i].begin : length();
  }
};

}  // namespace aucast::speaker
