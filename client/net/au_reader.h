#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "client/net/answer_ledger.h"
#include "client/net/received_stream.h"
#include "client/net/retries.h"
#include "client/net/stream_request.h"
#include "client/playback/keyframe_source.h"
#include "common/time.h"
#include "protocol/client_session.h"

namespace aucast::net {

struct AuReaderOptions : StreamRequest {
  std::string peer;                                 ///< HOST:PORT, the server's name in messages
  Duration silence_max = std::chrono::seconds(10);  ///< how long the first packet may take
  std::string token{};                              ///< shown in the hello; empty: none
  std::size_t hosts = 1;                            ///< how many are tried in turn
};

/// What the connection's owner has to do: send `send`, then do what `next` says.
struct Reaction {
  enum class Next : std::uint8_t {
    GoOn,
    Reconnect,       ///< drop this connection and make a new one, then call connected() again
    ReconnectLater,  ///< the same after `retry_after`
    Close,           ///< close the connection: nothing more will come from the server
  };
  std::string send;
  Next next = Next::GoOn;
  bool changed = false;  ///< there is something new for the player
  Milliseconds retry_after{0};
};

/// The AU Reader of the thesis (5.4.4.2) without its socket: leads the conversation with the
/// server, over as many connections as it takes, so that its stream comes into the buffers. It asks
/// the server to pause while they are full. It has no clock: the current time is handed in.
///
/// Room: a server that does not wait for answers is read no faster than the player makes room, so
/// that the ReceivedStream keeps at most as many keyframes beside the buffers as the window allows.
///
/// Classic: when the first thing that follows our hello is a keyframe, the reader answers that
/// keyframe, but it is kept aside until a second one or {-2} comes. If the server closes the
/// connection before that, the stream begins again on a new connection, and the keyframe is
/// dropped, so that it is not played twice.
///
/// Loss: with `reconnect` the face holds until there is a new connection. A recorded stream then
/// goes on from where it was cut off, if the server can do that; a live one goes on from the
/// present.
///
/// Low delay: with BufferOptions::low_delay the reader asks for a stream that needs no answers
/// (window=0). If the stream proves to be recorded, the reader connects once more and asks for a
/// window.
///
/// Thread: none of its own; the owner serialises the calls.
class AuReader {
 public:
  explicit AuReader(AuReaderOptions options);

  // === The connection's side.

  /// `round_trip`: of this connection; zero if unknown.
  [[nodiscard]] Reaction connected(Instant now, Duration round_trip = {});
  [[nodiscard]] Reaction received(std::string_view bytes, Instant now);
  /// The server closed its side (`broke` is empty), or the connection broke (`broke` is the cause,
  /// as a clause).
  [[nodiscard]] Reaction closed(Instant now, std::string_view broke = {});
  [[nodiscard]] Reaction time(Instant now);
  /// When time() is to be called; nullopt: not at all.
  [[nodiscard]] std::optional<Instant> deadline() const;
  /// No connection could be made; `reason` is a sentence for the user.
  Reaction unreachable(std::string reason);
  /// The connection cannot be used, and another attempt would fail in the same way.
  Reaction refused(playback::EndReason why, const std::string& reason);
  /// Call after take() or set_paused(): returns the codes that are now due to the server, and works
  /// on the bytes that had to wait.
  [[nodiscard]] Reaction speak(Instant now);
  /// The user leaves: returns the last bytes, to be sent if there is a connection.
  [[nodiscard]] std::string farewell() { return session_.stop(); }
  /// Counts bytes of the protocol that went out, without what a layer such as TLS adds.
  void note_sent(std::size_t bytes) { status_.bytes_sent += bytes; }
  /// False while received bytes wait for room: then read nothing, so that flow control holds the
  /// server back.
  [[nodiscard]] bool wants_bytes() const { return waiting_.empty(); }

  // === The player's side.

  [[nodiscard]] std::optional<playback::Keyframe> take();
  /// As KeyframeSource's functions of these names.
  [[nodiscard]] std::optional<playback::Voice> take_voice();
  [[nodiscard]] std::optional<playback::Caption> take_caption();
  /// True when take() would return a keyframe, or no more will ever come.
  [[nodiscard]] bool ready() const;
  /// True when speak() would do something.
  [[nodiscard]] bool has_output() const;
  /// Whether to call speak(); the player asks this after it has taken something. The same as
  /// has_output(), but true only once: then false until speak() has been called.
  [[nodiscard]] bool calls_for_speak();
  void set_paused(bool paused) { received_.set_paused(paused); }
  /// The user leaves: take() returns nullopt from now on.
  void leave();
  [[nodiscard]] playback::SourceStatus status() const;

 private:
  struct Came {
    std::uint64_t keyframes = 0;
    std::uint64_t bytes = 0;
  };

  void decode_waiting(Reaction& reaction, Instant now);
  [[nodiscard]] bool may_decode() const;
  void react(const std::vector<protocol::ClientEvent>& events, Reaction& reaction, Instant now);
  void handle(const protocol::SendBytes& event, Reaction& reaction);
  void handle(const protocol::DeliverKeyframe& event, Reaction& reaction);
  void handle(const protocol::DeliverVoice& event, Reaction& reaction);
  void handle(const protocol::DeliverCaption& event, Reaction& reaction);
  void handle(const protocol::Granted& event, Reaction& reaction);
  void handle(const protocol::StreamEnded& event, Reaction& reaction);
  void handle(const protocol::ReconnectClassic& event, Reaction& reaction);
  void handle(const protocol::SessionFailed& event, Reaction& reaction);
  void connect_anew(Reaction& reaction);
  void begin_session();

  void answer(std::string& send);
  [[nodiscard]] AnswerLedger::Wishes wishes() const;
  [[nodiscard]] bool negotiated() const;
  [[nodiscard]] std::size_t kept_max() const;
  void begin_again(Reaction& reaction, const std::string& reason, Milliseconds wait);
  [[nodiscard]] Retries::Keyframes keyframes_came() const;
  [[nodiscard]] bool left() const { return status_.end == playback::EndReason::Stopped; }
  void end(playback::EndReason reason, std::string detail);

  AuReaderOptions options_;
  protocol::ClientSessionOptions manner_;  ///< how the next connection is begun
  protocol::ClientSession session_;
  Retries retries_;
  Came lost_;  ///< over earlier connections, which were lost
  Instant connected_at_{};
  Instant now_{};        ///< the time that came with the current call
  std::string waiting_;  ///< received bytes that wait for room in received_
  ReceivedStream received_;
  AnswerLedger ledger_;
  bool called_for_speak_ = false;
  playback::SourceStatus status_;  ///< what status() does not get from the other members
};

}  // namespace aucast::net
