#pragma once

#include <optional>
#include <string>
#include <vector>

namespace aucast::server {

/// The manual page au-transmitter(1) in roff, from the table of options.
[[nodiscard]] std::string manual_page();

/// The script that makes a shell complete au-transmitter's options; nullopt unless the arguments
/// are --help-completion [bash|zsh|fish].
[[nodiscard]] std::optional<std::string> completion(const std::vector<std::string>& arguments);

}  // namespace aucast::server
