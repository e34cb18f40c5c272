#pragma once

#include "client/app/player_options.h"
#include "common/result.h"

namespace aucast::app {

/// face-player pose: one still as picture, mesh or numbers.
[[nodiscard]] Result<void> run_pose(const PlayerOptions& options);

/// face-player rules: the set after the rules on stdout.
[[nodiscard]] Result<void> run_rules(const PlayerOptions& options);

}  // namespace aucast::app
