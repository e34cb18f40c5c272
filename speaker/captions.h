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
  std::string text;  ///< one or two lines of at most 42 characters, unless a word is longer; a
                     ///< caption to protocol::is_caption()
};

/// Cuts the text into captions: at the ends of sentences, and wherever a caption would get too long
/// to read.
[[nodiscard]] std::vector<TimedCaption> captions_of(const Speech& speech, const Script& script);

/// The text of a WebVTT file.
[[nodiscard]] std::string format_webvtt(const std::vector<TimedCaption>& captions);

}  // namespace aucast::speaker
