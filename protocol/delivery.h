#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "protocol/answer_window.h"
#include "protocol/live_delivery.h"
#include "protocol/packet.h"
#include "protocol/packet_writer.h"
#include "protocol/recorded_delivery.h"
#include "protocol/served_stream.h"

namespace aucast::protocol {

/// Sends one stream, with its voice and captions, to one client: in the classic form unless grant()
/// was called, and appended to the caller's string. What recorded and live streams have in common
/// is here, the rest in RecordedDelivery and LiveDelivery. Thread: none of its own.
class Delivery {
 public:
  /// `loop`: a recorded stream starts again at its end. If it comes from another server that loops
  /// it, it starts again even without `loop`.
  Delivery(ServedStream stream, bool loop) : loop_(loop) { choose(std::move(stream)); }
  Delivery(const Delivery&) = delete;
  Delivery& operator=(const Delivery&) = delete;

  /// Replaces the stream. Call it only before anything was sent; answers and pauses received so far
  /// are kept.
  void choose(ServedStream stream);
  /// Changes to the form of level 2 and grants as much of `asked` as possible. `keyframe_ms` is
  /// only copied into the answer. Call this, and what follows, only when the stream is known.
  [[nodiscard]] HelloGranted grant(const HelloAsked& asked, std::uint32_t keyframe_ms);

  /// Appends everything that may be sent now. With a recorded stream it calls set_blocked(true) as
  /// soon as `out` has kOutputBytesMax bytes; to send more, call set_blocked(false) and then pump()
  /// again.
  void pump(std::string& out);
  /// Call it in place of pump() when a stream has something new. It sends all new moments of a live
  /// stream to a client that keeps up. pump() alone would send only the newest.
  void pump_new_moments(std::string& out);
  /// Whether {-2} is due: everything was sent and answered, nothing more will come, and the client
  /// has not paused.
  [[nodiscard]] bool complete() const;
  /// Whether all that we have of a recorded stream has been sent, but the stream is incomplete and
  /// no more will come.
  [[nodiscard]] bool broken_off() const { return recorded_ && recorded_->broken_off(); }

  /// Counts an answer to the oldest keyframe in flight or, if none is in flight, to the next one
  /// that is sent.
  void answer();
  void pause() { window_.set_paused(true); }
  void resume();
  /// With true, no keyframe is sent until a call with false.
  void set_blocked(bool blocked) { window_.set_blocked(blocked); }

  /// Whether keyframes may have to wait for the voice: the stream is recorded, and this client gets
  /// its voice.
  [[nodiscard]] bool waits_for_voice() const { return recorded_ && recorded_->voice(); }
  [[nodiscard]] const ServedStream& stream() const { return stream_; }
  [[nodiscard]] const AnswerWindow& window() const { return window_; }
  [[nodiscard]] const SentCounts& sent() const { return writer_.counts(); }

 private:
  ServedStream stream_;
  const bool loop_;
  AnswerWindow window_;
  PacketWriter writer_;
  // One of them, as soon as it is known what the stream is.
  std::optional<RecordedDelivery> recorded_;
  std::optional<LiveDelivery> live_;
};

}  // namespace aucast::protocol
