#pragma once

#include <optional>

#include "client/playback/jitter_meter.h"
#include "client/playback/keyframe_buffers.h"
#include "client/playback/live_playout.h"
#include "common/time.h"

namespace aucast::net {

/// Decides from the arrivals of a live stream's keyframes when to play them. With
/// BufferOptions::adapt the stream is delayed by as much as its jitter needs; until the jitter is
/// known, by a multiple of the round trip, because it takes at least one round trip to send a lost
/// packet again. With BufferOptions::low_delay each keyframe instead gets a time at which it is
/// due.
/// Thread: none of its own.
class LiveTiming {
 public:
  explicit LiveTiming(const playback::BufferOptions& options) : options_(options) {}

  /// `round_trip`: of the connection that begins; zero if unknown.
  void connected(Duration round_trip);
  /// Call it for a new connection or when the user has paused: the next keyframe may then come at
  /// any time.
  void begin_again();
  /// A keyframe has come, at `keyframe.arrived`. With low_delay, sets when it is due; with adapt,
  /// returns how much is to be buffered from now on (nullopt: as before). `untimed`: the time of a
  /// keyframe that has none of its own; `place`: its place in the stream, if known.
  [[nodiscard]] std::optional<Milliseconds> arrived(playback::Keyframe& keyframe,
                                                    Milliseconds untimed,
                                                    std::optional<Milliseconds> place);

  /// How much to buffer before the jitter is known.
  [[nodiscard]] Milliseconds first_delay() const { return first_delay_; }
  /// With low_delay, the recent average of the time from a keyframe's arrival until it is due.
  [[nodiscard]] Milliseconds low_delay() const;

 private:
  [[nodiscard]] std::optional<Milliseconds> measured(Instant now, Milliseconds time);

  playback::BufferOptions options_;
  playback::LivePlayout playout_;
  playback::JitterMeter jitter_;
  Milliseconds first_delay_{0};
  std::optional<Instant> measured_since_;  ///< nullopt: the next keyframe, being the first, says
                                           ///< nothing about the jitter
};

}  // namespace aucast::net
