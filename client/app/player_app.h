#pragma once

#include <string>
#include <vector>

namespace aucast::app {

/// face-player as a function: arguments without the program's name in, exit code of the contract
/// out. Results go to stdout, log and errors to stderr.
[[nodiscard]] int run_player(std::vector<std::string> arguments);

}  // namespace aucast::app
