#pragma once

#include <string>

#include "common/result.h"

namespace aucast::gui {

/// A sentence that came up in English, from the network or about what was made, in the language
/// that is used: its parts that the groups "net", "made" and "bad" of the table have. What they do
/// not have, such as a server's own words, stays as it is; in English all does.
[[nodiscard]] std::string in_used_language(const std::string& english);

/// The same of what is wrong with a file. Where nothing of it is known in the language that is
/// used, a sentence of that language about its kind comes first.
[[nodiscard]] std::string error_in_used_language(const Error& error);

}  // namespace aucast::gui
