#pragma once

#include <string>
#include <vector>

namespace aucast::app {

/// Runs face-player and returns its exit code. `arguments`: without the program's name. Results go
/// to stdout, log and errors to stderr.
[[nodiscard]] int run_player(std::vector<std::string> arguments);

}  // namespace aucast::app
