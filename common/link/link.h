#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "common/time.h"

namespace aucast::link {

/// Why a connection is closed.
struct Ending {
  enum class Why : std::uint8_t {
    Finished,   ///< after finish(): everything was sent and the peer has ended, or draining met a
                ///< limit or an error
    Lost,       ///< it broke before finish()
    NotTls,     ///< the peer does not speak TLS
    Untrusted,  ///< a certificate is not accepted, by us or by the peer
    TlsFailed,  ///< anything else that went wrong with TLS, such as a slow handshake
    NotMade,    ///< the connection that the link was to make never opened
    WebSocketFailed,  ///< the peer's frames break the rules of WebSocket
  };
  Why why = Why::Finished;
  std::string reason{};  ///< a clause for messages; text from the peer is escaped
};

/// What a link tells its user. The link makes none of these calls from within a call by its user,
/// except on_open() from within start().
class LinkUser {
 public:
  virtual ~LinkUser() = default;

  /// From now on write() may be called. on_open() itself is called at most once, and not at all if
  /// the link fails before it opens; then only on_failure() and on_closed() are called.
  virtual void on_open() = 0;
  virtual void on_bytes(std::string_view bytes) = 0;
  /// The peer has ended its sending side. Called at most once.
  virtual void on_peer_end() = 0;
  /// The link was blocked() and is not any more: everything that waited was sent.
  virtual void on_room() {}
  /// The time asked for by wake_at() has come.
  virtual void on_time() = 0;
  /// TLS or the WebSocket has failed. What is still to be sent is drained; then on_closed() gets
  /// the same Ending.
  virtual void on_failure(const Ending& /*failure*/) {}
  /// The link has closed; it makes no more calls. Not called after close().
  virtual void on_closed(const Ending& ending) = 0;
};

/// A connection that carries bytes: dialled or accepted, plain, TLS or WebSocket, over TCP or over
/// another link. Its user sees plain bytes, one timer and now(), and knows neither socket nor
/// clock.
///
/// finish() drains, in every kind of link alike: all that was written is sent, the sending side is
/// shut, and what the peer still sends is read and dropped until it ends, so that no reset loses
/// the last bytes. Limits::drain_time and drain_bytes limit this.
/// Thread: that of the executor it was made with. A link stays alive until a call to its user has
/// returned, so the user may let go of the link in that call.
class Link {
 public:
  Link() = default;
  virtual ~Link() = default;
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  /// Opens the link and begins to read. `user` must live until on_closed() or close().
  virtual void start(LinkUser& user) = 0;
  /// Changes the user of an open link.
  virtual void hand_over(LinkUser& user) = 0;
  /// Sends at once what the system takes; the rest waits. Ignored after finish().
  virtual void write(std::string_view bytes) = 0;
  /// Nothing more will be written: drains, then calls on_closed(). The user gets no other call
  /// before on_closed().
  virtual void finish() = 0;
  /// Closes at once, whatever is under way.
  virtual void close() = 0;
  /// If `reading` is false, starts no more reads, so that flow control holds the peer back; one
  /// on_bytes() may still come. Ignored after finish(), which reads until the peer ends.
  virtual void set_reading(bool reading) = 0;
  /// Asks for one call of on_time() at `when`, instead of any that was asked for before. nullopt:
  /// asks for no call.
  virtual void wake_at(std::optional<Instant> when) = 0;

  [[nodiscard]] virtual Instant now() const = 0;
  /// The smoothed round trip as the system measured it; zero when unknown.
  [[nodiscard]] virtual Duration round_trip() const = 0;
  /// Whether the peer takes no more for now, so that what is written waits.
  [[nodiscard]] virtual bool blocked() const = 0;
  /// Since when the link has been blocked without a byte being taken; nullopt: it is not blocked.
  [[nodiscard]] virtual std::optional<Instant> stuck_since() const = 0;
  [[nodiscard]] virtual std::size_t unsent_bytes() const = 0;
  /// Bytes sent so far, as they go over the wire.
  [[nodiscard]] virtual std::uint64_t wire_bytes() const = 0;
};

}  // namespace aucast::link
