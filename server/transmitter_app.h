#pragma once

#include <string>
#include <vector>

namespace aucast::server {

/// au-transmitter from its arguments (without the program's name) to its exit code: reads and
/// checks the sources, then serves them or, with --check, prints what they hold.
[[nodiscard]] int run_transmitter(std::vector<std::string> arguments);

}  // namespace aucast::server
