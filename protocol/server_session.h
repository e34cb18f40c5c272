#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "common/time.h"
#include "protocol/live_clock.h"
#include "protocol/packet.h"

namespace aucast::protocol {

/// A stream, encoded once per level and shared by all clients. Immutable while served, but for what
/// a LiveFeed replaces.
struct ServedStream {
  std::string name;                     ///< what a hello asks for; the file's stem
  std::vector<std::string> classic;     ///< one packet per keyframe
  std::vector<std::string> negotiated;  ///< the same keyframes, level 2
  std::optional<std::uint64_t> duration_ms;
  /// The same for who asked for the changes-only form; empty: it is not granted.
  std::vector<std::string> changes{};
  std::vector<Milliseconds> times{};  ///< of each keyframe, untimed ones with their default
  /// Live: what its sessions go by. Moved on by the owner, who then calls their on_moment();
  /// nothing: a recorded stream, which everybody gets from its beginning.
  const LiveTime* clock = nullptr;
};

/// What the sessions of one server have in common. Must outlive them.
struct ServerCatalogue {
  std::vector<ServedStream> streams;  ///< at least one; the first is what a classic client gets
  std::uint32_t keyframe_ms = 250;    ///< granted in the hello
  bool loop = false;                  ///< start again at the end instead of {-2}
  /// What a client must show in its hello; empty: nothing. It may change; those who are in stay.
  std::string token{};
};

/// What the owner of the connection has to do, in this order.
struct SendBytes {
  std::string bytes;
};
struct ShutdownSending {};  ///< after everything sent before is out; then go on reading
struct CloseConnection {
  enum class Why : std::uint8_t {
    Finished,       ///< the stream ended and the peer's last words are in (or the drain ran out)
    Stopped,        ///< the client's -4, or stop() of the server
    PeerGone,       ///< the peer closed or was lost before the end
    ProtocolError,  ///< bytes that are none of the protocol; `reason` says which, escaped
    Refused,        ///< an {error ...} was sent; `reason` is its text
  };
  Why why = Why::Finished;
  std::string reason;
};
using ServerEvent = std::variant<SendBytes, ShutdownSending, CloseConnection>;

[[nodiscard]] std::string_view name(CloseConnection::Why why);

/// Whether there is room for one more client.
enum class Admission : std::uint8_t {
  Welcome,
  Full,         ///< {error 503 ...} to who says hello, a plain close to others
  FullAddress,  ///< the same: too many come from this client's address
};

/// The server's side of one connection as a state machine: grace, hello, classic stop-and-wait or
/// windowed sending, pause, stop, end, drain. Live, a client that may be sent something gets the
/// newest moment; those between it and the last one sent are merged into it, which for states
/// means left out. No socket and no clock: bytes and moments go in,
/// events come out. After CloseConnection nothing more comes out.
/// Output of one call: at most kEarlyAnswersMax + window packets. The owner must not read on while
/// much of what it was told to send is still unsent, or a peer that answers without reading fills
/// its memory.
/// PROTOCOL.md section "Server" is the table it follows.
/// Thread: none of its own; one session per connection.
class ServerSession {
 public:
  /// `round_trip`: measured on the connection, zero if unknown; sets the grace for a first byte.
  ServerSession(const ServerCatalogue& catalogue, Duration round_trip, Instant now,
                Admission admission = Admission::Welcome);
  ~ServerSession();
  ServerSession(ServerSession&&) noexcept;
  ServerSession& operator=(ServerSession&&) noexcept;

  [[nodiscard]] std::vector<ServerEvent> on_bytes(std::string_view bytes, Instant now);
  /// The peer shut its sending side: banked answers are still used up.
  [[nodiscard]] std::vector<ServerEvent> on_peer_end(Instant now);
  /// The connection broke; nothing can be sent any more.
  [[nodiscard]] std::vector<ServerEvent> on_lost(Instant now);
  /// Call when deadline() has come.
  [[nodiscard]] std::vector<ServerEvent> on_time(Instant now);
  /// The clock of a live stream has moved on, by one moment or several. Without effect on others.
  [[nodiscard]] std::vector<ServerEvent> on_moment(Instant now);
  /// Live: the socket takes no more for now, so no keyframe is handed out; or it does again, and
  /// the newest is.
  [[nodiscard]] std::vector<ServerEvent> hold(bool held, Instant now);
  /// The server itself stops: {-2} at once, then the closing of level 1.
  [[nodiscard]] std::vector<ServerEvent> stop(Instant now);

  /// When on_time() wants to be called next; nothing: no timer is running.
  [[nodiscard]] std::optional<Instant> deadline() const;

  [[nodiscard]] Level level() const;
  [[nodiscard]] bool paused() const;
  /// True while an answer is awaited that the peer owes: what --client-timeout measures.
  [[nodiscard]] bool awaiting_answer() const;
  /// True while keyframes of a live stream are sent.
  [[nodiscard]] bool live() const;
  [[nodiscard]] std::string_view stream_name() const;
  [[nodiscard]] std::uint64_t packets_sent() const;   ///< keyframes handed out
  [[nodiscard]] std::uint64_t payload_bytes() const;  ///< their bytes, without hello and {-2}
  /// Live keyframes that were left out because the client could not take them in time.
  [[nodiscard]] std::uint64_t packets_merged() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace aucast::protocol
