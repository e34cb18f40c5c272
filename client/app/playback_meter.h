#pragma once

#include <optional>

#include "client/app/player_stats.h"
#include "client/playback/playback.h"

namespace aucast::app {

/// Measures how long playing takes, on the clock of the caller.
class PlaybackMeter {
 public:
  explicit PlaybackMeter(PlayerStats& stats) : stats_(stats) {}

  /// This keyframe begins as playback is advanced to `now`.
  void begun(const playback::Playback& playback, const playback::KeyframeBegun& keyframe,
             Instant now);
  /// Playback has been advanced to `now`; true when its first keyframe has begun by that.
  bool advanced(const playback::Playback& playback, Instant now);
  /// Something else is played from now on.
  void begin_again();

 private:
  void count(const playback::Playback& playback, Instant now);

  PlayerStats& stats_;
  std::optional<Instant> first_begin_;
  std::uint64_t played_ = 0;
  AuFrame under_way_;
  bool told_ = false;  ///< that the first has begun
};

}  // namespace aucast::app
