#pragma once

#include <optional>
#include <string>
#include <vector>

namespace aucast::server {

/// au-transmitter(1) in roff, from the table of options.
[[nodiscard]] std::string manual_page();

/// What makes a shell complete au-transmitter's options, where the arguments ask for that:
/// --help-completion [bash|zsh|fish].
[[nodiscard]] std::optional<std::string> completion(const std::vector<std::string>& arguments);

}  // namespace aucast::server
