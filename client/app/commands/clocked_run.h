#pragma once

#include <functional>
#include <memory>

#include "client/app/assets.h"
#include "client/app/player_options.h"
#include "client/app/player_stats.h"
#include "client/playback/playback.h"
#include "client/sound/sound_out.h"
#include "client/sound/sound_track.h"

namespace aucast::app {

/// Plays to the end in real time without drawing: computes the activations at each of the 50
/// positions of every keyframe when that position is due. Asks `stop` at least every 50 ms, and
/// ends if it returns true. `out` plays `track` or, if that is null, the voice of what is played.
/// If `out` is null, nothing is heard.
void run_clocked(const Assets& assets, const PlayerOptions& options, playback::Playback& playback,
                 std::unique_ptr<sound::SoundOut> out, sound::SoundTrack* track,
                 const std::function<bool()>& stop, PlayerStats& stats);

}  // namespace aucast::app
