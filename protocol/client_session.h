#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "common/action_unit.h"
#include "common/time.h"
#include "protocol/packet.h"
#include "protocol/session_events.h"
#include "protocol/voice_packet.h"

namespace aucast::protocol {

/// How the player wants to talk.
struct ClientSessionOptions {
  bool negotiate = true;  ///< false: never send a hello (--protocol classic)
  HelloAsked hello;
  /// Longest wait for the server's first packet, from when the connection is made.
  Duration silence_max = std::chrono::seconds(10);
};

/// A keyframe has arrived; `aus` is the full face even if the packet was a changes-only one. The
/// owner stores the keyframe and then calls answer_received() or pause().
struct DeliverKeyframe {
  AuFrame aus;
  std::optional<std::uint32_t> time_ms;  ///< as in the packet
  std::optional<std::uint64_t> place_ms;
  bool changes_only = false;  ///< the packet was a changes-only one
};
/// A voice packet has come. Its place is on the client's clock, which shows the granted `from` (0
/// if none) plus the times of the keyframes received. The packet is heard when the face comes to
/// that place.
struct DeliverVoice {
  VoicePacket packet;
};
/// A caption has come. Its place is on the same clock.
struct DeliverCaption {
  CaptionData caption;
};
/// The server has granted level 2.
struct Granted {
  HelloGranted hello;
};
/// {-2}: everything has been sent. It needs no answer; the owner closes when it likes.
struct StreamEnded {};
/// Drop this connection and everything that came over it, and connect once more with
/// `negotiate = false`: the server took the hello for garbage.
struct ReconnectClassic {};
struct SessionFailed {
  enum class Why : std::uint8_t {
    Lost,           ///< closed or broken before {-2}
    ProtocolError,  ///< bytes that are not the protocol
    Refused,        ///< the server's {error ...}
    Silent,         ///< no complete packet within silence_max
  };
  Why why = Why::Lost;
  std::string reason;         ///< a sentence; text from the peer is escaped
  std::optional<int> code{};  ///< if Refused: the server's error code
};
using ClientEvent = std::variant<SendBytes, DeliverKeyframe, DeliverVoice, DeliverCaption, Granted,
                                 StreamEnded, ReconnectClassic, SessionFailed>;

/// The player's side of one connection as a state machine. No socket and no clock. After
/// StreamEnded, ReconnectClassic or SessionFailed nothing more comes out.
/// Thread: none of its own; one session per connection.
class ClientSession {
 public:
  explicit ClientSession(ClientSessionOptions options);
  ~ClientSession();
  ClientSession(ClientSession&&) noexcept;
  ClientSession& operator=(ClientSession&&) noexcept;

  [[nodiscard]] std::vector<ClientEvent> on_connected(Instant now);
  /// Reads `bytes` up to the end of the first packet; `bytes` is then only what comes after that.
  /// Call it again while bytes are left.
  [[nodiscard]] std::vector<ClientEvent> on_bytes(std::string_view& bytes);
  /// The server closed its side (`broke` is empty), or the connection broke (`broke` says why).
  [[nodiscard]] std::vector<ClientEvent> on_closed(std::string_view broke = {});
  [[nodiscard]] std::vector<ClientEvent> on_time(Instant now);
  [[nodiscard]] std::optional<Instant> deadline() const;

  // What the owner says; each returns the bytes to send (empty: nothing to say now).
  /// The oldest unanswered keyframe is stored: `1`.
  [[nodiscard]] std::string answer_received();
  /// No room: `-1`. In classic it stands in place of the answer to the unanswered keyframe; in
  /// level 2 it is spontaneous and answers nothing.
  [[nodiscard]] std::string pause();
  /// Room again: `-3`. It answers nothing; in classic, `-1` was the answer already.
  [[nodiscard]] std::string resume();
  /// The user leaves: `-4`, at the first call only.
  [[nodiscard]] std::string stop();

  [[nodiscard]] Level level() const;
  /// How many keyframes the server may send before it waits for an answer; the owner keeps room for
  /// as many. 1 in classic. If the server sends more, the owner stops reading, which holds the
  /// server back.
  [[nodiscard]] int window() const;
  [[nodiscard]] bool paused() const;
  [[nodiscard]] std::size_t unanswered() const;
  [[nodiscard]] std::uint64_t keyframes_received() const;
  [[nodiscard]] std::uint64_t payload_bytes() const;  ///< of these keyframes, as received

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace aucast::protocol
