#pragma once

#include <string>
#include <vector>

#include "client/gui/texts/texts.h"
#include "common/result.h"

namespace aucast::gui {

/// Translates a message that other code made in English (english_errors.h) into the language in
/// use. Parts that are not in that table, such as a server's own words, stay as they are.
[[nodiscard]] std::string in_used_language(const std::string& english);

/// The same for an error. If no part of it can be translated, a translated sentence about its kind
/// comes first.
[[nodiscard]] std::string error_in_used_language(const Error& error);

/// The values that `english` has at the places of this row of english_errors.h, in their order;
/// empty: it is another message.
[[nodiscard]] std::vector<std::string> places_said(TextKey row, const std::string& english);

}  // namespace aucast::gui
