#pragma once

#include <vector>

#include "client/app/player_options.h"
#include "common/options.h"

namespace aucast::app {

/// How the table of a recogniser is read.
[[nodiscard]] std::vector<OptionRow> table_rows(gui::TableSettings& table);

/// The options about a connection. Command::Play takes them too, though it connects to nothing.
[[nodiscard]] std::vector<OptionRow> receiving_rows(PlaybackOptions& playback);

}  // namespace aucast::app
