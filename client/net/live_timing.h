#pragma once

#include <optional>

#include "client/playback/jitter_meter.h"
#include "client/playback/keyframe_buffers.h"
#include "client/playback/live_playout.h"
#include "common/time.h"

namespace aucast::net {

/// Decides from the arrivals of a live stream's keyframes when to play them. With
/// BufferOptions::adapt the stream is delayed by what its jitter needs, and before that is known by
/// the round trip: a lost packet takes at least one to be sent again. With BufferOptions::low_delay
/// each keyframe says when it is due instead.
/// Thread: none of its own.
class LiveTiming {
 public:
  explicit LiveTiming(const playback::BufferOptions& options) : options_(options) {}

  /// `round_trip`: of the connection that begins; zero if unknown.
  void connected(Duration round_trip);
  /// A new connection, or the user has paused: the next keyframe may come at any time.
  void begin_again();
  /// A keyframe has come, at `keyframe.arrived`. Sets when it is due, or returns how much is to be
  /// buffered from now on. `untimed`: the time of a keyframe that has none of its own; `place`: in
  /// the stream, if known.
  [[nodiscard]] std::optional<Milliseconds> arrived(playback::Keyframe& keyframe,
                                                    Milliseconds untimed,
                                                    std::optional<Milliseconds> place);

  /// What is buffered before the jitter is known.
  [[nodiscard]] Milliseconds first_delay() const { return first_delay_; }
  /// With low delay: from a keyframe's arrival until it is due, the recent average.
  [[nodiscard]] Milliseconds low_delay() const;

 private:
  [[nodiscard]] std::optional<Milliseconds> measured(Instant now, Milliseconds time);

  playback::BufferOptions options_;
  playback::LivePlayout playout_;
  playback::JitterMeter jitter_;
  Milliseconds first_delay_{0};
  std::optional<Instant> measured_since_;  ///< nothing: the next keyframe tells nothing of it
};

}  // namespace aucast::net
