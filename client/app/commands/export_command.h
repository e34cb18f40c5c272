#pragma once

#include "client/app/player_options.h"
#include "common/result.h"

namespace aucast::app {

/// Runs face-player export: writes the face, with a stream file as its animation, as a GLB file.
/// Prints what the file contains and how far its face is from the one that face-player draws.
[[nodiscard]] Result<void> run_export(const PlayerOptions& options);

}  // namespace aucast::app
