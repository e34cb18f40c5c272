#pragma once

#include <filesystem>
#include <vector>

#include "client/app/player_options.h"
#include "common/result.h"

namespace aucast::app {

/// The files that a command may read, without regard to whether they are there: the stream with its
/// sound and captions, rules, the face, what comes with it in the data folder, and secrets.
[[nodiscard]] std::vector<std::filesystem::path> files_read(const PlayerOptions& options);

/// Refuses options that would write over a file that is read, or write one file twice; see
/// check_not_read() and check_distinct(). What a gallery writes is known only to itself.
[[nodiscard]] Result<void> check_outputs(const PlayerOptions& options);

/// Fails if what is written at the end of a run, --stats or --sheet, could not be. Call it when the
/// folder of --frames has been made.
[[nodiscard]] Result<void> check_last_outputs(const OutputOptions& output);

}  // namespace aucast::app
