#pragma once

#include <memory>
#include <optional>

#include "common/time.h"
#include "protocol/encoded_stream.h"
#include "protocol/live_channel.h"
#include "protocol/live_clock.h"

namespace aucast::protocol {

/// A recorded stream that is sent live, with its own clock.
/// Thread: none of its own.
class LiveReplay final : public LiveChannel {
 public:
  /// `stream` has at least one keyframe, and with `loop` takes some time.
  LiveReplay(std::shared_ptr<const EncodedStream> stream, bool loop, Instant begin);

  /// Begins all moments that are due by `now`, or ends; false when there is nothing to do. What is
  /// more than LiveClock::kLiveLagMax late is left out.
  bool advance(Instant now);
  /// When advance() has something to do; nothing after the end.
  [[nodiscard]] std::optional<Instant> next_at() const { return clock_.next_at(); }
  /// What is sent.
  [[nodiscard]] const std::shared_ptr<const EncodedStream>& stream() const { return stream_; }

 private:
  std::shared_ptr<const EncodedStream> stream_;
  LiveClock clock_;
};

}  // namespace aucast::protocol
