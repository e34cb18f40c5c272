#pragma once

#include "client/app/player_options.h"
#include "common/result.h"

namespace aucast::app {

/// Runs face-player pose: makes one still as a picture, a mesh or numbers.
[[nodiscard]] Result<void> run_pose(const PlayerOptions& options);

/// Runs face-player rules: prints the set after the rules to stdout.
[[nodiscard]] Result<void> run_rules(const PlayerOptions& options);

}  // namespace aucast::app
