#pragma once

#include <string>
#include <vector>

#include "common/result.h"
#include "speaker/speech.h"

namespace aucast::speaker {

struct VoiceOptions {
  std::string language = "en";  ///< a voice or a language of espeak-ng
  int words_per_minute = 150;   ///< 80-450
  int pitch = 50;               ///< 0-99
};

/// The text as espeak-ng speaks it. Usage: no such voice. Failed: espeak-ng's data is not there.
/// One at a time in a process: the library keeps its state in globals.
[[nodiscard]] Result<Speech> speak(const std::string& text, const VoiceOptions& options);

/// Every voice: "en-gb  English (Great Britain)".
[[nodiscard]] Result<std::vector<std::string>> voices();

}  // namespace aucast::speaker
