#pragma once

#include <optional>

#include "client/app/player_stats.h"
#include "client/playback/playback.h"

namespace aucast::app {

/// Measures how long playing takes, on the clock of the caller.
class PlaybackMeter {
 public:
  explicit PlaybackMeter(PlayerStats& stats) : stats_(stats) {}

  /// To be called for each keyframe that advancing `playback` to `now` begins.
  void keyframe_begun(const playback::Playback& playback, const playback::KeyframeBegun& keyframe,
                      Instant now);
  /// To be called whenever `playback` was advanced to `now`: counts what has been played until
  /// then. True once, when the first keyframe has begun.
  [[nodiscard]] bool count(const playback::Playback& playback, Instant now);
  /// Something else is played from now on.
  void begin_again();

 private:
  void count_played(const playback::Playback& playback, Instant now);

  PlayerStats& stats_;
  std::optional<Instant> first_begin_;
  std::uint64_t played_ = 0;
  AuFrame under_way_;
  bool told_ = false;  ///< that the first has begun
};

}  // namespace aucast::app
