#pragma once

#include <string>
#include <vector>

#include "common/time.h"
#include "speaker/script.h"
#include "speaker/speech.h"

namespace aucast::speaker {

struct TimedCaption {
  Milliseconds begin{0};
  Milliseconds end{0};
  std::string text;  ///< one line or two of at most 42 characters where words allow it
};

/// The text as it is heard, cut at the ends of sentences and where it would get too long to read.
[[nodiscard]] std::vector<TimedCaption> captions_of(const Speech& speech, const Script& script);

/// As a WebVTT file.
[[nodiscard]] std::string format_webvtt(const std::vector<TimedCaption>& captions);

}  // namespace aucast::speaker
