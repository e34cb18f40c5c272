#pragma once

#include <string>
#include <vector>

namespace aucast::server {

/// Runs au-transmitter: reads and checks the sources, then serves them or, with --check, prints
/// what they contain. `arguments` are without the program's name. Returns the exit code.
[[nodiscard]] int run_transmitter(std::vector<std::string> arguments);

}  // namespace aucast::server
