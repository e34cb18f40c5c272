#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/result.h"
#include "common/time.h"

namespace aucast::voice {

/// What is to be read from a place on, until the next one; empty: nothing.
struct PlacedText {
  Milliseconds place{0};
  std::string text;  ///< UTF-8, lines parted by line feeds, without markup
  friend bool operator==(const PlacedText&, const PlacedText&) = default;
};

/// Reads the text of a WebVTT file. `file` is what messages call it. Cues in ascending places: one
/// that begins while another lasts takes its place, and where none follows at once there is an
/// empty text. Markup, settings, notes and styles are left out. BadData, with file:line:column,
/// for what is no WebVTT, a time that is none and what is no UTF-8.
[[nodiscard]] Result<std::vector<PlacedText>> parse_webvtt(std::string_view text,
                                                           std::string_view file);

}  // namespace aucast::voice
