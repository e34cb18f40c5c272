#pragma once

#include <functional>

#include "client/app/player_options.h"
#include "common/result.h"

namespace aucast::app {

/// face-player gallery: pictures, index.html and manifest.csv in a folder. Every file is written
/// whole or not at all, the page last; files of an earlier run that this one does not make stay.
/// Same options and face, same bytes. `stop` is asked before each picture; when it says true that
/// is a failure, since the pictures are not all there, and nothing half written is left.
[[nodiscard]] Result<void> run_gallery(const PlayerOptions& options,
                                       const std::function<bool()>& stop);

}  // namespace aucast::app
