#pragma once

#include <string>
#include <vector>

namespace aucast::speaker {

/// Runs au-speaker. `arguments` are without the program's name. Returns the exit code.
[[nodiscard]] int run_speaker(std::vector<std::string> arguments);

}  // namespace aucast::speaker
