#pragma once

#include <optional>

#include "client/playback/jitter_meter.h"
#include "client/playback/keyframe_buffers.h"
#include "client/playback/live_playout.h"
#include "common/time.h"

namespace aucast::net {

/// What the arrivals of a live stream's keyframes say of when to play them.
/// With BufferOptions::adapt the stream is held back by what its jitter asks for, and before that
/// is known by the round trip: a packet that was lost takes one and more to come again.
/// With BufferOptions::low_delay each keyframe says when it is due instead.
/// Thread: none of its own.
class LiveTiming {
 public:
  explicit LiveTiming(const playback::BufferOptions& options) : options_(options) {}

  /// `round_trip`: of the connection that begins; zero if unknown.
  void connected(Duration round_trip);
  /// Another connection, or the user has paused: the next keyframe may come at any time.
  void begin_again();
  /// A keyframe has come, at `keyframe.arrived`. Sets when it is due, or returns how much is to be
  /// held ready from now on. `untimed`: the time of a keyframe that has none of its own; `place`:
  /// in the stream, if known.
  [[nodiscard]] std::optional<Milliseconds> arrived(playback::TimedAus& keyframe,
                                                    Milliseconds untimed,
                                                    std::optional<Milliseconds> place);

  /// What is held ready before the jitter is known.
  [[nodiscard]] Milliseconds first_delay() const { return first_delay_; }
  /// With low delay: from a keyframe's arrival until it is due; the average of lately.
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
