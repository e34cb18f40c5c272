#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "client/net/live_timing.h"
#include "client/net/spoken_queue.h"
#include "client/playback/keyframe_buffers.h"
#include "client/playback/keyframe_source.h"
#include "common/time.h"
#include "protocol/client_session.h"

namespace aucast::net {

/// What has come of a stream and waits to be taken: keyframes, voice and captions, with their
/// places on the client's clock (PROTOCOL.md, Voice), which goes on over all connections.
///
/// Room: every keyframe that was added and not yet taken is in the buffers, kept beside them
/// because they were full, or kept aside as the first one of a server that may be classic.
/// Invariant: keyframes are given in the order in which they were added.
///
/// Thread: none of its own.
class ReceivedStream {
 public:
  /// `speed`: as StreamRequest::speed.
  ReceivedStream(const playback::BufferOptions& options, std::optional<Milliseconds> speed);

  // === The connection's side.

  /// A connection has been made. `round_trip`: its own; zero if unknown.
  void connected(Duration round_trip) { timing_.connected(round_trip); }
  /// From now on the stream is as `hello` says; that of a classic server is as the defaults say.
  void begin(const protocol::HelloGranted& hello);
  /// What begin() was called with last; the defaults before that.
  [[nodiscard]] const protocol::HelloGranted& hello() const { return hello_; }

  /// Adds a keyframe that has come at `now`. With `aside`, it waits until another keyframe,
  /// break_off() or end() shows that the connection counts.
  void add(const protocol::DeliverKeyframe& event, Instant now, bool aside);
  void add(const protocol::VoicePacket& packet);
  void add(const protocol::CaptionData& caption);
  /// The connection is lost: what came is played until the stream goes on.
  void break_off();
  /// The connection does not count: a keyframe that was kept aside has not come.
  void forget_aside();
  /// Nothing more will come.
  void end();

  /// How many keyframes are kept because the buffers are full: case A of KeyframeBuffers::store().
  [[nodiscard]] std::size_t kept() const { return kept_.size(); }
  /// Where a recorded stream would go on, as the server counts.
  [[nodiscard]] Milliseconds place() const { return clock_ - clock_shift_; }

  // === The player's side.

  [[nodiscard]] std::optional<playback::Keyframe> take();
  /// True when take() would return a keyframe, or no more will ever come.
  [[nodiscard]] bool ready() const { return buffers_.has_next() || finished(); }
  /// True when no more will ever come.
  [[nodiscard]] bool finished() const { return buffers_.finished(); }
  [[nodiscard]] SpokenQueue& spoken() { return spoken_; }
  /// While the user pauses, arrivals say nothing about the link.
  void set_paused(bool paused);
  [[nodiscard]] bool paused() const { return paused_; }
  /// Fills in what it knows.
  void describe(playback::SourceStatus& status) const;

 private:
  void let_in();
  void take_in(const playback::Keyframe& keyframe);
  void store_kept();
  [[nodiscard]] Milliseconds untimed() const;

  playback::BufferOptions options_;
  std::optional<Milliseconds> speed_;
  protocol::HelloGranted hello_;
  playback::KeyframeBuffers buffers_;
  std::optional<playback::Keyframe> aside_;
  std::deque<playback::Keyframe> kept_;
  LiveTiming timing_;
  bool paused_ = false;
  SpokenQueue spoken_;
  Milliseconds clock_{0};        ///< the sum of the times of all keyframes received
  Milliseconds clock_shift_{0};  ///< what to add to a place on the wire to get the place on clock_
};

}  // namespace aucast::net
