#pragma once

#include <string>
#include <vector>

#include "common/result.h"
#include "common/time.h"
#include "speaker/speech.h"

namespace aucast::speaker {

struct VoiceOptions {
  std::string language = "en";  ///< a voice or a language of espeak-ng
  int words_per_minute = 150;   ///< 80-450
  int pitch = 50;               ///< 0-99
};

/// Speaks the text with espeak-ng. Fails with Usage if there is no such voice, with BadData if the
/// text has no words or takes longer than `longest`, with Failed if espeak-ng's data is missing. Do
/// not call it from two threads at once: the library keeps its state in globals.
[[nodiscard]] Result<Speech> speak(const std::string& text, const VoiceOptions& options,
                                   Milliseconds longest = kSpeechMax);

/// One line for every voice, its language and its name with a tab between: "en-gb", tab, "English
/// (Great Britain)".
[[nodiscard]] Result<std::vector<std::string>> voices();

}  // namespace aucast::speaker
