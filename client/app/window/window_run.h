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

/// Opens a window that shows what plays, until the user leaves it or, with --exit-at-end, playing
/// ends. `playback`: what to play, null for the neutral face; on return, what was played last,
/// because the user may have connected elsewhere. `out`: plays the sound; null: no sound.
/// `settings`: used at the start and saved at the end. In a build without OpenGL it fails and says
/// so.
[[nodiscard]] Result<void> run_window(Assets& assets, const PlayerOptions& options,
                                      std::unique_ptr<playback::Playback>& playback,
                                      std::unique_ptr<sound::SoundOut> out,
                                      WindowSettings& settings, const std::function<bool()>& stop,
                                      PlayerStats& stats);

}  // namespace aucast::app
