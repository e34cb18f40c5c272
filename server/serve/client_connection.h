#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/link/link.h"
#include "common/time.h"
#include "protocol/server_session.h"
#include "server/status/client_log.h"
#include "server/status/stats.h"

namespace aucast::server {

/// One client: carries out a ServerSession's decisions on a link of any kind.
///
///   link --bytes--> session --events--> link
///   the link's timer: the session's deadline, --client-timeout, --batch
///
/// The session begins when the link opens. A keyframe of a live stream is sent only when the link
/// has taken everything before it.
/// Thread: that of the link. The connection stays alive until a call from the link has returned.
class ClientConnection final : public link::LinkUser,
                               public std::enable_shared_from_this<ClientConnection> {
 public:
  /// `why`: a sentence or clause about the end, for the connection's owner.
  using OnClosed = std::function<void(const ClientRecord&, const std::string& why)>;
  /// The client is a publisher whose stream is to be taken: passes on the open link, the client's
  /// hello and its address.
  using OnPublisher = std::function<void(std::shared_ptr<link::Link>, const protocol::HelloAsked&,
                                         std::string peer)>;

  struct Settings {
    std::uint64_t number = 0;  ///< of the client, for the log and the ClientRecord
    std::string peer;          ///< ADDR:PORT
    ClientLog* log = nullptr;  ///< must outlive the connection; null: nothing is logged
    /// Longest wait for an answer that the client owes, or for the link to take any bytes; 0: no
    /// limit.
    Milliseconds client_timeout{0};
    protocol::Admission admission = protocol::Admission::Welcome;
    Milliseconds batch{0};  ///< --batch: how long small writes wait for more; 0: not at all
    protocol::TokenCount token_count;  ///< of wrong tokens; must outlive the connection
    protocol::Silence silence = protocol::Silence::Classic;
    OnPublisher on_publisher{};  ///< needed where the catalogue has publishers
  };

  /// `on_closed` is called once, when the link is closed.
  ClientConnection(std::shared_ptr<link::Link> link,
                   std::shared_ptr<const protocol::ServerCatalogue> catalogue, Settings settings,
                   OnClosed on_closed);
  ~ClientConnection() override;
  ClientConnection(const ClientConnection&) = delete;
  ClientConnection& operator=(const ClientConnection&) = delete;

  void start();
  /// Instead of start(), for a link that is already open and on which `bytes` have come.
  void take_over(std::string_view bytes);
  /// A stream has something new, see ServerSession::on_moment().
  void on_moment();
  /// The voice of a recorded stream has grown.
  void on_voice();
  /// The server stops: {-2}, then the link drains.
  void stop();
  /// Whether it still serves: it is neither ending nor closed.
  [[nodiscard]] bool goes_on() const { return state_ == State::Serving; }
  /// Whether send_away() would have an effect.
  [[nodiscard]] bool movable() const { return goes_on() && session_ && session_->movable(); }
  /// The server stops and another one takes over: closes without {-2}, see
  /// ServerSession::send_away(). Returns false if this client cannot be sent away; nothing was done
  /// then.
  bool send_away();
  /// Closes at once, whatever is under way.
  void abort();

  /// What the client was sent so far.
  [[nodiscard]] ClientRecord so_far() const;
  /// How many bytes are not sent yet, in the link or held back by --batch.
  [[nodiscard]] std::size_t output_bytes() const;
  /// Since when the link has been blocked without taking a byte; nullopt: it is not blocked.
  [[nodiscard]] std::optional<Instant> unsent_since() const { return link_->stuck_since(); }
  [[nodiscard]] bool paused() const { return session_ && session_->paused(); }

 private:
  /// In this order, but any may be left out.
  enum class State : std::uint8_t {
    Serving,
    Draining,  ///< the last byte was written
    Noted,     ///< why it ended is known and logged; the link may still drain
    Closed,
  };

  void on_open() override;
  void on_bytes(std::string_view bytes) override;
  void on_peer_end() override;
  void on_room() override;
  void on_time() override;
  void on_failure(const link::Ending& failure) override;
  void on_closed(const link::Ending& ending) override;

  template <typename... Args>
  void say(spdlog::level::level_enum level, spdlog::format_string_t<Args...> format,
           Args&&... args) {
    if (settings_.log != nullptr)
      settings_.log->say(link_->now(), level, format, std::forward<Args>(args)...);
  }
  void carry_out(std::vector<protocol::ServerEvent> events);
  void end_with(const protocol::CloseConnection& end);
  void hand_over(const protocol::HelloAsked& hello);
  void note_pace();
  void send(std::string_view bytes);
  void flush();
  [[nodiscard]] bool gathers();
  void finish_sending();
  void note_end(ClientEnd end_reason, std::string_view reason, bool in_order);
  void lose();
  void close();
  void go_on();
  [[nodiscard]] std::optional<Instant> patience_ends();
  [[nodiscard]] bool noted() const { return state_ == State::Noted || state_ == State::Closed; }

  std::shared_ptr<link::Link> link_;                            ///< null: it was handed over
  std::shared_ptr<const protocol::ServerCatalogue> catalogue_;  ///< outlives the session
  std::optional<protocol::ServerSession> session_;              ///< nullopt: the link is not open
  State state_ = State::Serving;
  std::optional<protocol::CloseConnection> farewell_;  ///< what is noted when the link has drained
  std::optional<Instant> gathered_until_;
  std::optional<Instant> owed_since_;  ///< since when the client owes an answer
  std::optional<Instant> sending_since_;
  std::string gathered_;  ///< small writes that wait for more
  Settings settings_;
  OnClosed on_closed_;
  std::string why_;  ///< why it ended
  ClientRecord record_;
};

}  // namespace aucast::server
