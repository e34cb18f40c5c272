#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "common/result.h"

namespace aucast {

/// Parses `arguments` (without the program's name) into the variables bound to `app`. Fails with a
/// Usage error of one line for an unknown option and for a missing or impossible value. The line
/// names the argument and, for an unknown option, the nearest known one.
[[nodiscard]] Result<void> parse_command_line(CLI::App& app, std::vector<std::string> arguments);

}  // namespace aucast
