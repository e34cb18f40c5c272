#pragma once

#include <vector>

#include "client/app/player_options.h"
#include "common/options.h"

namespace aucast::app {

/// The options of a command in the order of --help, bound to `options`.
[[nodiscard]] std::vector<OptionRow> option_rows(Command command, PlayerOptions& options);

}  // namespace aucast::app
