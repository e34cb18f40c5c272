#pragma once

#include <memory>
#include <optional>

#include "common/time.h"
#include "protocol/encoded_stream.h"
#include "protocol/encoded_track.h"
#include "protocol/live_channel.h"
#include "protocol/live_clock.h"

namespace aucast::protocol {

/// A recorded stream that is sent live, by a clock of its own.
/// Thread: none of its own.
class LiveReplay final : public LiveChannel {
 public:
  /// `stream` has at least one keyframe; with `loop`, not all of its times are 0. Voice and
  /// captions that begin during a moment are sent when the moment begins. `spoken` is null if there
  /// are none.
  LiveReplay(std::shared_ptr<const EncodedStream> stream, bool loop, Instant begin,
             std::shared_ptr<const SpokenTrack> spoken = nullptr);

  /// Begins all moments that are due by `now`, or ends the stream; returns false if nothing was
  /// due. Moments that are more than LiveClock::kLiveLagMax late are left out.
  bool advance(Instant now);
  /// When to call advance() next; nullopt after the end.
  [[nodiscard]] std::optional<Instant> next_at() const { return clock_.next_at(); }
  /// The recorded stream that is sent.
  [[nodiscard]] const std::shared_ptr<const EncodedStream>& stream() const { return stream_; }

  [[nodiscard]] const std::shared_ptr<const SpokenTrack>& spoken() const { return spoken_; }

 private:
  void go_to(std::uint64_t number);
  void play_spoken(Milliseconds begin, Milliseconds end);

  std::shared_ptr<const EncodedStream> stream_;
  std::shared_ptr<const SpokenTrack> spoken_;
  LiveClock clock_;
  std::uint64_t next_number_ = 0;  ///< of the moment that begins at `next_begin_`
  Milliseconds next_begin_{0};
  Milliseconds turn_begin_{0};  ///< where the present turn began, on the channel's clock
  Milliseconds turn_time_{Milliseconds::max()};  ///< length of a turn, in a loop
  std::size_t next_voice_ = 0;
  std::size_t next_caption_ = 0;
};

}  // namespace aucast::protocol
