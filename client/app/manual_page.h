#pragma once

#include <optional>
#include <string>
#include <vector>

namespace aucast::app {

/// face-player(1) in roff, from the pages of --help.
[[nodiscard]] std::string manual_page();

/// What makes a shell complete face-player's options and commands, where the arguments ask for
/// that: --help-completion [bash|zsh|fish].
[[nodiscard]] std::optional<std::string> completion(const std::vector<std::string>& arguments);

}  // namespace aucast::app
