#pragma once

#include <string>
#include <vector>

#include "client/gui/texts/texts.h"
#include "common/result.h"

namespace aucast::gui {

/// Translates a message that other code made in English (english_errors.h) into the language in
/// use. Parts that are not in that table, such as a server's own words, stay as they are. Where
/// face-player's options are named, and the window has a field for the same, names that field.
[[nodiscard]] std::string in_used_language(const std::string& english);

/// The same for an error. If no part of it can be translated and its kind is BadData or Unreadable,
/// a sentence in the language in use comes first, which says what that kind means.
[[nodiscard]] std::string error_in_used_language(const Error& error);

/// If `english` is the message of this row of english_errors.h, returns the values at its places,
/// in their order; else returns an empty list.
[[nodiscard]] std::vector<std::string> places_said(TextKey row, const std::string& english);

}  // namespace aucast::gui
