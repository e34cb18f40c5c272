#pragma once

#include "client/app/player_options.h"
#include "common/result.h"

namespace aucast::app {

/// face-player gallery: pictures, index.html and manifest.csv in a folder. Every file is written
/// whole or not at all, the page last; files of an earlier run that this one does not make stay.
/// Same options and face, same bytes.
[[nodiscard]] Result<void> run_gallery(const PlayerOptions& options);

}  // namespace aucast::app
