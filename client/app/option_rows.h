#pragma once

#include <vector>

#include "client/app/player_options.h"
#include "common/manual.h"
#include "common/options.h"

namespace aucast::app {

/// The options of a command in the order of --help, bound to `options`.
[[nodiscard]] std::vector<OptionRow> option_rows(Command command, PlayerOptions& options);

/// What --help and the manual page say about a command.
[[nodiscard]] CommandPage command_page(Command command);

/// The pages of all commands; the first is Command::Watch.
[[nodiscard]] std::vector<CommandPage> command_pages();

}  // namespace aucast::app
