#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "common/time.h"
#include "protocol/encoded_stream.h"
#include "protocol/live_channel.h"
#include "protocol/packet.h"
#include "protocol/served_stream.h"
#include "protocol/voice_cursor.h"

namespace aucast::protocol {

/// Counts what one client was sent.
struct SentCounts {
  std::uint64_t keyframes = 0;
  std::uint64_t payload_bytes = 0;  ///< of the keyframes alone
  /// Keyframes of a live stream that were left out, since the client was too slow for them.
  std::uint64_t keyframes_merged = 0;
  std::uint64_t voice_packets = 0;
  /// Left out with such keyframes, or since they would begin before the end of the last one.
  std::uint64_t voice_left_out = 0;
  std::uint64_t spoken_bytes = 0;  ///< of voice packets and captions
};

/// Sends one stream, with its voice and captions, to one client. Knows what was sent and what may
/// be sent now: follows the window of section 6 of PROTOCOL.md, stops while the client pauses, and
/// merges live moments. Sends the classic form unless grant() was called. Appends bytes to the
/// caller's string. Thread: none of its own.
class Delivery {
 public:
  /// `loop`: a recorded stream starts again at its end. If it comes from another server that loops
  /// it, it starts again even without `loop`.
  Delivery(ServedStream stream, bool loop) : stream_(std::move(stream)), loop_(loop) {}

  /// Replaces the stream. Call it only before anything was sent; answers and pauses received so far
  /// are kept.
  void choose(ServedStream stream) { stream_ = std::move(stream); }
  /// Changes to the form of level 2 and grants as much of `asked` as possible. `keyframe_ms` is
  /// only copied into the answer.
  [[nodiscard]] HelloGranted grant(const HelloAsked& asked, std::uint32_t keyframe_ms);

  /// Appends everything that may be sent now. With a recorded stream it calls set_blocked(true) as
  /// soon as `out` has kOutputBytesMax bytes; to send more, call set_blocked(false) and then pump()
  /// again.
  void pump(std::string& out);
  /// Call it in place of pump() when a live channel has new moments. It sends all of them to a
  /// client that keeps up. pump() alone would send only the newest.
  void pump_new_moments(std::string& out);
  /// Whether {-2} is due: everything was sent and answered, nothing more will come, and the client
  /// has not paused.
  [[nodiscard]] bool complete() const;

  /// Whether all that we have of a recorded stream has been sent, but the stream is incomplete and
  /// no more will come.
  [[nodiscard]] bool broken_off() const;

  /// Counts an answer to the oldest keyframe in flight or, if none is in flight, to the next one
  /// that is sent.
  void answer();
  void pause() { paused_ = true; }
  void resume();
  /// With true, no keyframe is sent until a call with false.
  void set_blocked(bool blocked) { blocked_ = blocked; }

  /// Whether keyframes may have to wait for the voice: the stream is recorded, and this client gets
  /// its voice.
  [[nodiscard]] bool waits_for_voice() const { return voice_ && !stream_.live(); }

  [[nodiscard]] const ServedStream& stream() const { return stream_; }
  [[nodiscard]] bool answers() const { return window_ > 0; }
  [[nodiscard]] bool paused() const { return paused_; }
  [[nodiscard]] bool blocked() const { return blocked_; }
  [[nodiscard]] std::size_t in_flight() const { return in_flight_; }
  [[nodiscard]] std::size_t banked() const { return banked_; }
  [[nodiscard]] const SentCounts& sent() const { return sent_; }

 private:
  [[nodiscard]] const EncodedStream& recorded() const;
  [[nodiscard]] const SpokenTrack* spoken() const { return stream_.recorded()->spoken.get(); }
  /// Whether the client sees the first keyframe again after the last: sent again, or repeated by
  /// the client itself.
  [[nodiscard]] bool in_loop() const { return loop_ || stream_.loops_there(); }
  [[nodiscard]] bool loops() const { return !one_turn_ && in_loop(); }
  [[nodiscard]] const PacketList& packets() const;
  [[nodiscard]] std::string_view packet_of(const LiveMoment& moment, bool full) const;
  [[nodiscard]] std::size_t window_for(int asked) const;
  [[nodiscard]] std::uint64_t begin_at(std::uint64_t from_ms);
  [[nodiscard]] bool sends_spoken() const { return voice_ || text_; }
  [[nodiscard]] bool has_next() const;
  [[nodiscard]] bool at_end() const;
  [[nodiscard]] bool may_send() const;
  void send_keyframe(std::string_view packet, std::string& out);
  void send_recorded(std::string& out);
  void begin_turn();
  [[nodiscard]] bool ends_turn(Milliseconds place) const;
  [[nodiscard]] bool spoken_may_reach(Milliseconds end) const;
  [[nodiscard]] bool is_full(const std::string& out);
  [[nodiscard]] bool send_spoken(Milliseconds end, Milliseconds turn_end, std::string& out);
  void send_moment(const LiveMoment& moment, std::string& out);
  void skip_spoken_before(Milliseconds place);
  [[nodiscard]] Milliseconds live_spoken_end() const;
  void send_live_spoken(std::string& out);
  void send_voice(const EncodedVoice& voice, Milliseconds shift, std::string& out);
  void send_caption(const CaptionData& caption, Milliseconds shift, std::string& out);

  ServedStream stream_;
  bool loop_;
  bool one_turn_ = false;  ///< only one turn is sent, and the client repeats it
  bool granted_ = false;   ///< else in the classic form
  std::size_t window_ = 1;
  bool delta_ = false;  ///< the changes-only form was granted
  bool voice_ = false;
  bool text_ = false;

  std::size_t in_flight_ = 0;  ///< sent and not answered
  std::size_t banked_ = 0;     ///< answers that came while there was nothing to answer
  bool paused_ = false;
  bool blocked_ = false;
  SentCounts sent_;

  /// The client's clock: where the stream began, plus the times of the keyframes sent.
  Milliseconds sent_to_{0};
  VoiceCursor voice_cursor_;
  std::uint64_t next_voice_ = 0;    ///< recorded: index in the track; live: number in the channel
  std::uint64_t next_caption_ = 0;  ///< likewise
  Milliseconds last_caption_{0};    ///< place of the last caption sent
  /// Recorded, on the client's clock: what is over by then is left out. Live, on the channel's:
  /// what begins before is.
  Milliseconds heard_from_{0};

  // Recorded only.
  std::size_t next_packet_ = 0;
  std::size_t next_answered_ = 0;  ///< the keyframe that the next answer is for
  Milliseconds answered_to_{0};    ///< the end of the last answered keyframe
  Milliseconds turn_begin_{0};     ///< on the client's clock: where the present turn began

  // Live only.
  bool full_next_ = true;                     ///< the next packet must not be changes-only
  std::optional<std::uint64_t> last_moment_;  ///< the number of the last moment sent
  Milliseconds shift_{0};  ///< what to add to a place on the channel's clock to get the client's
  Milliseconds joined_at_{0};  ///< on the channel's clock: where the first moment sent begins
};

}  // namespace aucast::protocol
