#pragma once

#include <string>
#include <vector>

namespace aucast::speaker {

/// au-speaker from its arguments (without the program's name) to its exit code.
[[nodiscard]] int run_speaker(std::vector<std::string> arguments);

}  // namespace aucast::speaker
