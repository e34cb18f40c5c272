#pragma once

#include <string>
#include <vector>

namespace aucast::app {

/// Runs face-player. `arguments` are without the program's name; returns the exit code. Results go
/// to stdout, log and errors to stderr.
[[nodiscard]] int run_player(std::vector<std::string> arguments);

}  // namespace aucast::app
