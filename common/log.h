#pragma once

#include <string_view>

#include <spdlog/spdlog.h>

#include "common/result.h"

namespace aucast {

/// Sends the log to stderr, one line an entry with time and level, coloured on a terminal unless
/// NO_COLOR is set. `level` is one of trace, debug, info, warning, error, off. Usage error
/// otherwise.
[[nodiscard]] Result<void> set_up_log(std::string_view program, std::string_view level);

}  // namespace aucast
