#pragma once

#include <functional>
#include <memory>

#include "client/app/assets.h"
#include "client/app/player_options.h"
#include "client/app/player_stats.h"
#include "client/app/window/settings/window_settings.h"
#include "client/playback/playback.h"
#include "client/sound/sound_out.h"

namespace aucast::app {

/// Shows what plays in a window until the user leaves it (or, with --exit-at-end, playing ends).
/// `playback` may be null: the neutral face; afterwards it is what was played last, because the
/// user may connect elsewhere. `out` plays the sound, and may be null. `settings` are in force at
/// the start, and kept at the end. In a build without OpenGL it fails and says so.
[[nodiscard]] Result<void> run_window(Assets& assets, const PlayerOptions& options,
                                      std::unique_ptr<playback::Playback>& playback,
                                      std::unique_ptr<sound::SoundOut> out,
                                      WindowSettings& settings, const std::function<bool()>& stop,
                                      PlayerStats& stats);

}  // namespace aucast::app
