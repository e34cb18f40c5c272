#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <asio/ip/tcp.hpp>
#include <asio/steady_timer.hpp>

#include "common/time.h"
#include "common/tls/channel.h"
#include "common/tls/context.h"
#include "protocol/limits.h"
#include "protocol/server_session.h"
#include "server/serve/client_log.h"
#include "server/status/stats.h"

namespace aucast::server {

/// One client: a socket that carries out what a ServerSession decides.
///
///   reading --bytes--> session --events--> output --> socket
///   timer: the session's deadline, --client-timeout, the end of lingering
///
/// When the session has closed the connection lingers: what was begun is written, the sending side
/// is shut, what still comes is read and dropped, so that the peer gets every last word and no
/// reset; at most kDrainBytesMax and kDrainTimeMax without progress.
/// With TLS what is read and written goes through a channel first, and the session begins when the
/// handshake is done, for which there is kTlsHandshakeTimeMax.
/// Bounded: while kOutputBytesMax wait for a peer that does not read, nothing is read from it
/// either, so it can only ask for as much as one read and its banked answers are worth. Of a live
/// stream the next keyframe is handed out when the socket has taken all before it.
/// Thread: that of the socket's executor. Lives until its last handler ran.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  using OnClosed = std::function<void(const ClientRecord&)>;

  struct Settings {
    std::uint64_t number = 0;  ///< of the client, for the log and the record
    std::string peer;          ///< ADDR:PORT
    ClientLog* log = nullptr;  ///< outlives the connection
    /// Longest wait for an answer that is owed, or for the socket to take anything; 0: for ever.
    Milliseconds client_timeout{0};
    protocol::Admission admission = protocol::Admission::Welcome;
    int unsent_bytes_max = 0;  ///< that the system may hold back unsent; 0: as much as it likes
    std::optional<tls::Context> tls{};  ///< nothing: plain
    Milliseconds batch{0};              ///< small writes wait so long for each other
  };

  /// `on_closed` is called once, when the socket is closed.
  Connection(asio::ip::tcp::socket socket,
             std::shared_ptr<const protocol::ServerCatalogue> catalogue, Settings settings,
             OnClosed on_closed);
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  void start();
  /// The clock of a live stream has moved on.
  void on_moment();
  /// Soon on_moment() will be called: has the processor fetch what it needs.
  void fetch_ahead() const;
  /// The server stops: {-2}, then the closing of level 1.
  void stop();
  /// Closes now, whatever is under way.
  void abort();

  /// What it got so far.
  [[nodiscard]] ClientRecord so_far() const;
  /// What waits because the socket takes no more.
  [[nodiscard]] std::size_t output_bytes() const;
  /// Since when something waits without a byte of it going out; nothing when nothing does.
  [[nodiscard]] std::optional<Instant> unsent_since() const { return unsent_since_; }
  [[nodiscard]] bool paused() const { return session_.paused(); }

 private:
  [[nodiscard]] bool handshaking() const { return tls_ && !tls_->ready(); }
  void read_tls(std::string_view bytes);
  void hand_to_session(std::string_view bytes);
  void peer_ended();
  void want_shut();
  void fail_tls(std::string_view reason, bool answer_plain);
  void carry_out(std::vector<protocol::ServerEvent> events);
  void queue(std::string bytes);
  void append(std::string bytes);
  void session_closed(std::string_view end_reason, std::string_view reason, bool in_order);
  void go_on();
  void read();
  void on_read(const std::error_code& error, std::size_t bytes);
  [[nodiscard]] bool gathers();
  void write();
  void write_when_possible();
  void shut_sending();
  void lost(const std::error_code& error);
  void drop(std::size_t bytes);
  void finish();

  void arm_timer();
  void on_timer();
  [[nodiscard]] std::optional<Instant> patience_ends();
  void measure_sending();
  [[nodiscard]] bool output_done() const { return output_bytes() == 0; }

  // First what every moment of a live stream needs: fetch_ahead() knows that it lies together.
  asio::ip::tcp::socket socket_;
  std::shared_ptr<const protocol::ServerCatalogue> catalogue_;  ///< outlives the session
  protocol::ServerSession session_;
  std::unique_ptr<tls::Channel> tls_;  ///< nothing: plain
  std::string output_;
  std::size_t written_ = 0;  ///< of output_
  bool reading_ = false;
  bool awaiting_write_ = false;  ///< the socket takes no more for now
  bool peer_ended_ = false;
  bool shut_wanted_ = false;
  bool shut_done_ = false;
  bool lingering_ = false;  ///< the session has closed
  bool finished_ = false;
  bool sending_measured_ = false;
  std::optional<Instant> armed_for_;
  std::optional<Instant> batch_until_;  ///< small writes are being gathered
  std::optional<Instant> owed_since_;   ///< an answer
  std::optional<Instant> stuck_since_;  ///< the output
  std::optional<Instant> unsent_since_;
  std::optional<Instant> sending_since_;
  Settings settings_;

  asio::steady_timer timer_;
  OnClosed on_closed_;
  ClientRecord record_;
  Instant handshake_until_{};
  std::size_t dropped_bytes_ = 0;
  Instant linger_until_{};
  std::array<char, protocol::kReadBytesMax> input_{};
};

}  // namespace aucast::server
