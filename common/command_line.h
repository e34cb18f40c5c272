#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "common/result.h"

namespace aucast {

/// Parses `arguments` (without the program's name) into the variables bound to `app`. An unknown
/// option, a missing or an impossible value is a Usage error of one line that names the argument
/// and, for an option, the nearest known one.
[[nodiscard]] Result<void> parse_command_line(CLI::App& app, std::vector<std::string> arguments);

}  // namespace aucast
