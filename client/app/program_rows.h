#pragma once

#include <vector>

#include "client/app/player_options.h"
#include "common/options.h"

namespace aucast::app {

/// The window, and whether there is one.
[[nodiscard]] std::vector<OptionRow> window_rows(PlayerOptions& options);

/// What every command takes.
[[nodiscard]] std::vector<OptionRow> program_rows(PlayerOptions& options);

}  // namespace aucast::app
