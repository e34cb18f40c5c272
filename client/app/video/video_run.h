#pragma once

#include <functional>

#include "client/app/assets.h"
#include "client/app/player_options.h"
#include "client/app/player_stats.h"
#include "client/playback/playback.h"
#include "client/sound/sound_track.h"

namespace aucast::app {

/// Plays to the end on the video clock (`playback` must be made for it), and waits only for
/// keyframes that have not come yet. Draws what the options ask for. `stop` is asked often;
/// when it returns true, playing stops and the files are finished with what they have. Failures of
/// the source are in its status; the Result is only about pictures and files. `track`: the sound of
/// what is played; null: the voice that comes with it.
[[nodiscard]] Result<void> run_video(const Assets& assets, const PlayerOptions& options,
                                     playback::Playback& playback, sound::SoundTrack* track,
                                     const std::function<bool()>& stop, PlayerStats& stats);

}  // namespace aucast::app
