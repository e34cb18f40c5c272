#pragma once

#include <vector>

#include "client/app/player_options.h"
#include "common/manual.h"

namespace aucast::app {

/// What --help and the manual page say about a command.
[[nodiscard]] CommandPage command_page(Command command);

/// The pages of all commands; the first is Command::Watch.
[[nodiscard]] std::vector<CommandPage> command_pages();

}  // namespace aucast::app
