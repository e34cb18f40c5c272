#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "client/app/assets.h"
#include "client/app/player_options.h"
#include "common/result.h"

namespace aucast::app {

/// Runs face-player gallery: writes pictures, index.html and manifest.csv into a folder. Each file
/// is written completely or not at all, and index.html last. Files of an earlier run stay if this
/// one does not replace them. The same options and face give the same bytes. `stop` is asked before
/// each picture; if it returns true, the command fails, because pictures are missing, and leaves no
/// incomplete file.
[[nodiscard]] Result<void> run_gallery(const PlayerOptions& options,
                                       const std::function<bool()>& stop);

/// The same, but returns the sentence about what was made rather than printing it. With
/// `options.quiet` nothing is printed at all, and the sentence also says if videos are missing.
/// `on_drawn` is called after each picture with the number so far and the total.
[[nodiscard]] Result<std::string> make_gallery(
    const PlayerOptions& options, const std::function<bool()>& stop,
    const std::function<void(std::size_t drawn, std::size_t total)>& on_drawn = {});

/// How many pictures a gallery would have. Fails with the Usage errors of plan_gallery().
[[nodiscard]] Result<std::size_t> gallery_size(const Assets& assets, const PlayerOptions& options);

}  // namespace aucast::app
