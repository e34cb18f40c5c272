#pragma once

#include <string>

namespace aucast::gui {

/// A sentence that came up in English, from the network or about what was made, in the language
/// that is used: its parts that the groups "net" and "made" of the table have. What they do not
/// have, such as a server's own words, stays as it is; in English all does.
[[nodiscard]] std::string in_used_language(const std::string& english);

}  // namespace aucast::gui
