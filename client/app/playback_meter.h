#pragma once

#include <optional>

#include "client/app/player_stats.h"
#include "client/playback/playback.h"

namespace aucast::app {

/// Measures how long playing takes, by the times that the caller hands in.
class PlaybackMeter {
 public:
  explicit PlaybackMeter(PlayerStats& stats) : stats_(stats) {}

  /// Call it for each keyframe that begins when `playback` is advanced to `now`.
  void keyframe_begun(const playback::Playback& playback, const playback::KeyframeBegun& keyframe,
                      Instant now);
  /// Call it whenever `playback` was advanced to `now`: counts what has been played up to then.
  /// Returns true once, when the first keyframe has begun.
  [[nodiscard]] bool count(const playback::Playback& playback, Instant now);
  /// Call it when another stream begins to play.
  void begin_again();

 private:
  void count_played(const playback::Playback& playback, Instant now);

  PlayerStats& stats_;
  std::optional<Instant> first_begin_;
  std::uint64_t played_ = 0;
  AuFrame under_way_;
  bool told_ = false;  ///< count() has returned true
};

}  // namespace aucast::app
