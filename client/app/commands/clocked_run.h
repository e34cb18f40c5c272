#pragma once

#include <functional>

#include "client/app/assets.h"
#include "client/app/player_options.h"
#include "client/app/player_stats.h"
#include "client/playback/playback.h"

namespace aucast::app {

/// Plays to the end in real time without drawing: a timer drives the 50 positions of every
/// keyframe, activations are computed at each. `stop` is asked at least every 50 ms.
void run_clocked(const Assets& assets, const PlayerOptions& options, playback::Playback& playback,
                 const std::function<bool()>& stop, PlayerStats& stats);

}  // namespace aucast::app
