#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/time.h"
#include "protocol/delivery.h"
#include "protocol/limits.h"
#include "protocol/packet.h"
#include "protocol/publishers.h"
#include "protocol/session_events.h"
#include "protocol/wrong_tokens.h"

namespace aucast::protocol {

/// What the sessions of one server have in common. Must outlive them. The streams and the token may
/// change at any time; a session nevertheless keeps the stream that it sends, and a client that was
/// let in stays.
struct ServerCatalogue {
  /// The first is what a classic client gets. Empty only if `patience` says that a stream may come
  /// later.
  std::vector<ServedStream> streams;
  std::uint32_t keyframe_ms = kDefaultKeyframeTime.count();  ///< told in the hello
  bool loop = false;  ///< recorded streams start again at the end instead of {-2}
  /// What a client must show in its hello; empty: no token is needed.
  std::string token{};
  /// A program that started this server to see its own camera, as face-player --mirror does, must
  /// show this token instead of the other (Admission::Owner). Empty: there is no such program.
  std::string owner_token{};
  std::string id{};  ///< of this server, told to relays; empty: none
  /// Who may bring streams; null: nobody.
  std::shared_ptr<const Publishers> publishers{};
  /// Called with the hello of a publisher that may bring the stream. Returns the refusal if the
  /// stream cannot be taken now.
  std::function<std::optional<ErrorReply>(const HelloAsked&)> publish_refused{};
  /// How long a client waits for a stream that is not here yet; nullopt: no stream can come later.
  std::optional<Milliseconds> patience{};
};

[[nodiscard]] std::string_view name(CloseConnection::Why why);

/// Whether there is room for one more client, and which token it needs.
enum class Admission : std::uint8_t {
  Welcome,
  Owner,        ///< welcome if it shows ServerCatalogue::owner_token
  Full,         ///< a client that says hello gets {error 503 ...}, any other a plain close
  FullAddress,  ///< the same, because too many clients come from its address
};

/// How to treat a client that sends no hello.
enum class Silence : std::uint8_t {
  Classic,  ///< as one of level 1
  Refused,  ///< it gets {error 400 ...} after kHelloTimeMax: for WebSockets
};

/// The server's side of one connection as a state machine: grace, hello, classic stop-and-wait or
/// windowed sending, pause, stop, end. Whenever a client of a live stream may be sent
/// something, it gets the newest moment; moments that it missed are skipped (LiveDelivery). No
/// socket and no clock: bytes and the current time go in, events come out. After CloseConnection or
/// HandOver nothing more comes out. One call puts out at most a little more than kOutputBytesMax;
/// if more is left, the session is blocked() until set_blocked(false) is called. Whoever has the
/// connection must not read on while much of what has come out is still unsent: a peer that answers
/// without reading would fill the memory. Follows the table in PROTOCOL.md, section "Server".
/// Thread: none of its own; one session per connection.
class ServerSession {
 public:
  /// `round_trip`: measured on the connection, zero if unknown; sets the grace for a first byte.
  ServerSession(const ServerCatalogue& catalogue, Duration round_trip, Instant now,
                Admission admission = Admission::Welcome, TokenCount token_count = {},
                Silence silence = Silence::Classic);
  ~ServerSession();
  ServerSession(ServerSession&&) noexcept;
  ServerSession& operator=(ServerSession&&) noexcept;

  [[nodiscard]] std::vector<ServerEvent> on_bytes(std::string_view bytes, Instant now);
  /// The peer shut its sending side: banked answers still count.
  [[nodiscard]] std::vector<ServerEvent> on_peer_end(Instant now);
  /// The connection broke; nothing can be sent any more.
  [[nodiscard]] std::vector<ServerEvent> on_lost(Instant now);
  /// Call when deadline() has come.
  [[nodiscard]] std::vector<ServerEvent> on_time(Instant now);
  /// Call when a stream has something new: a live one has a new moment, or one that comes from
  /// another server has grown. Without effect unless this session waits for that.
  [[nodiscard]] std::vector<ServerEvent> on_moment(Instant now);
  /// Call when the voice of this session's stream has grown. Without effect if the stream has none.
  [[nodiscard]] std::vector<ServerEvent> on_voice(Instant now);
  /// Call it with true when the socket takes no more: no keyframe is handed out until a call with
  /// false. After that a live stream goes on with its newest moment. A session that sends a
  /// recorded stream also becomes blocked() when a call has handed out kOutputBytesMax.
  [[nodiscard]] std::vector<ServerEvent> set_blocked(bool blocked, Instant now);
  /// The server itself stops: {-2} at once, then the closing of PROTOCOL.md section 8.
  [[nodiscard]] std::vector<ServerEvent> stop(Instant now);
  /// The server itself stops and another one takes over: a client that is sent a stream in level 2,
  /// or waits for one, is cut off without {-2}, and may come back with `from=`. Without effect for
  /// all others.
  [[nodiscard]] std::vector<ServerEvent> send_away(Instant now);
  /// Whether send_away() would have an effect.
  [[nodiscard]] bool movable() const;

  /// When to call on_time() next; nullopt: no timer is running.
  [[nodiscard]] std::optional<Instant> deadline() const;

  [[nodiscard]] Level level() const;
  [[nodiscard]] bool paused() const;
  /// True while the peer owes an answer and has not paused: --client-timeout limits this time.
  [[nodiscard]] bool awaiting_answer() const;
  /// Whether keyframes wait for set_blocked(false).
  [[nodiscard]] bool blocked() const;
  /// True while this session sends keyframes of a live stream.
  [[nodiscard]] bool live() const;
  [[nodiscard]] std::string_view stream_name() const;
  /// The stream's keyframes; null: it is not recorded, or not known yet.
  [[nodiscard]] const EncodedStream* recorded() const;
  [[nodiscard]] const SentCounts& sent() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace aucast::protocol
