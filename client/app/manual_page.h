#pragma once

#include <string>

namespace aucast::app {

/// face-player(1) in roff, from the pages of --help.
[[nodiscard]] std::string manual_page();

/// What makes bash complete face-player's options and commands.
[[nodiscard]] std::string completion();

}  // namespace aucast::app
