#pragma once

#include <cstddef>
#include <string>

#include "common/time.h"
#include "protocol/answer_window.h"
#include "protocol/encoded_stream.h"
#include "protocol/packet.h"
#include "protocol/packet_writer.h"
#include "protocol/upstream_stream.h"

namespace aucast::protocol {

/// Sends a recorded stream to one client, with its voice and captions if the client gets them.
/// Keyframes then wait for the voice. See Delivery for what the functions do.
/// Thread: none of its own.
class RecordedDelivery {
 public:
  /// `loops`: the client sees the first keyframe again after the last. What is passed by reference
  /// must outlive this object.
  RecordedDelivery(const RecordedStream& stream, bool loops, AnswerWindow& window,
                   PacketWriter& writer)
      : stream_(stream), loops_(loops), window_(window), writer_(writer) {}

  void grant(const HelloAsked& asked, HelloGranted& granted);
  void pump(std::string& out);
  /// Call when the oldest keyframe that was not answered has been.
  void on_answered();
  [[nodiscard]] bool complete() const;
  [[nodiscard]] bool broken_off() const;
  [[nodiscard]] bool voice() const { return voice_; }

 private:
  [[nodiscard]] std::uint64_t begin_at(std::uint64_t from_ms);
  [[nodiscard]] bool sends_spoken() const { return voice_ || text_; }
  [[nodiscard]] bool has_next() const;
  [[nodiscard]] bool at_end() const { return encoded_->extent == Extent::Whole && !has_next(); }
  void begin_turn();
  [[nodiscard]] bool ends_turn(Milliseconds place) const;
  [[nodiscard]] bool spoken_may_reach(Milliseconds end) const;
  [[nodiscard]] bool is_full(const std::string& out);
  [[nodiscard]] bool send_spoken(Milliseconds end, Milliseconds turn_end, std::string& out);

  const RecordedStream& stream_;
  const bool loops_;
  AnswerWindow& window_;
  PacketWriter& writer_;
  // Of `stream_`, and in the classic form unless there was a grant.
  const EncodedStream* encoded_ = stream_.encoded.get();
  const PacketList* packets_ = &encoded_->classic;
  bool starts_again_ = loops_;  ///< else the client itself repeats the only turn, or nobody does
  bool delta_ = false;          ///< the changes-only form was granted
  bool voice_ = false;
  bool text_ = false;

  std::size_t next_packet_ = 0;
  std::size_t next_voice_ = 0;
  std::size_t next_caption_ = 0;
  std::size_t next_answered_ = 0;  ///< the keyframe that the next answer is for
  // On the client's clock: where the stream began, plus the times of the keyframes sent.
  Milliseconds sent_to_{0};
  Milliseconds answered_to_{0};  ///< the end of the last answered keyframe
  Milliseconds turn_begin_{0};   ///< where the present turn began
  Milliseconds heard_from_{0};   ///< voice that is over by then is left out
};

}  // namespace aucast::protocol
