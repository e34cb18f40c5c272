#pragma once

#include <optional>

#include "client/app/player_stats.h"
#include "client/pipeline/player.h"

namespace aucast::app {

/// Advances a player and measures how long playing takes, on the clock of the caller.
class PlaybackMeter {
 public:
  explicit PlaybackMeter(PlayerStats& stats) : stats_(stats) {}

  /// Moves the player to `now`; true when its first keyframe has begun by this call.
  bool advance(pipeline::Player& player, Instant now,
               const pipeline::Player::OnBegin& on_begin = {});
  /// Something else is played from now on.
  void begin_again();

 private:
  void count(const playback::Playback& playback, Instant now);

  PlayerStats& stats_;
  std::optional<Instant> first_begin_;
  std::uint64_t played_ = 0;
  AuFrame under_way_;
};

}  // namespace aucast::app
