#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "client/app/assets.h"
#include "client/app/player_options.h"
#include "common/result.h"

namespace aucast::app {

/// face-player gallery: pictures, index.html and manifest.csv in a folder. Every file is written
/// whole or not at all, the page last; files of an earlier run that this one does not make stay.
/// Same options and face, same bytes. `stop` is asked before each picture; when it returns true the
/// command fails, because pictures are missing, and leaves no incomplete file.
[[nodiscard]] Result<void> run_gallery(const PlayerOptions& options,
                                       const std::function<bool()>& stop);

/// The same without printing that: the sentence about what there is now is returned. With
/// `options.quiet` nothing is printed at all, and the sentence says, too, that videos are missing.
/// `on_drawn` is called after each picture with the number so far and the total.
[[nodiscard]] Result<std::string> make_gallery(
    const PlayerOptions& options, const std::function<bool()>& stop,
    const std::function<void(std::size_t drawn, std::size_t total)>& on_drawn = {});

/// How many pictures a gallery would have. Usage error as plan_gallery() has it.
[[nodiscard]] Result<std::size_t> gallery_size(const Assets& assets, const PlayerOptions& options);

}  // namespace aucast::app
