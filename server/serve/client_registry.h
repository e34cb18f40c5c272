#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <asio/ip/tcp.hpp>

#include "common/link/link.h"
#include "protocol/server_session.h"
#include "protocol/wrong_tokens.h"
#include "server/serve/address_counts.h"
#include "server/serve/client_connection.h"
#include "server/serve/client_room.h"
#include "server/settings/transmitter_options.h"
#include "server/status/client_log.h"
#include "server/status/stats.h"
#include "server/status/status.h"

namespace aucast::server {

/// All connections from accept to close, including those that are read only to be refused: decides
/// who may come in, and counts what was sent. Thread: that of the links.
class ClientRegistry {
 public:
  using OpenLink = std::function<std::shared_ptr<link::Link>()>;
  using OnEmpty = std::function<void()>;

  /// Of `options` only the limits and times of clients are used. They and `stats`, which gets the
  /// record of each client that leaves, outlive it. `on_empty`: no client is left except servers
  /// that were dialled from here; called again when these leave. `on_publisher`: a client turned
  /// out to be a publisher, and counts as a client no more. `room`: the bound where the options
  /// have none.
  ClientRegistry(const TransmitterOptions& options, Stats& stats, OnEmpty on_empty,
                 ClientConnection::OnPublisher on_publisher = {},
                 const ClientRoom& room = room_now())
      : options_(options),
        clients_max_(options.max_clients != 0 ? options.max_clients : clients_with_room(room)),
        stats_(stats),
        on_empty_(std::move(on_empty)),
        on_publisher_(std::move(on_publisher)) {}
  ClientRegistry(const ClientRegistry&) = delete;
  ClientRegistry& operator=(const ClientRegistry&) = delete;

  /// How a client has come.
  enum class Way : std::uint8_t {
    Tcp,
    Owner,  ///< the program that started us with --preview, or another one on this host
    WebSocket,
    Dialled,  ///< by us: --push
    Guest,    ///< over TCP, where --preview was told to let others in
  };

  /// A connection has come in. While kRefusalsMax others are being refused, the link is not even
  /// opened.
  void welcome(const asio::ip::tcp::endpoint& peer,
               std::shared_ptr<const protocol::ServerCatalogue> catalogue,
               const OpenLink& open_link, Way way = Way::Tcp);

  /// Another server, which we have dialled and which takes what is served here: `bytes` have come
  /// on the link, which is open. No limit of clients counts, and the log is left to `on_closed`.
  void serve(std::string peer, std::shared_ptr<const protocol::ServerCatalogue> catalogue,
             std::shared_ptr<link::Link> link, std::string_view bytes,
             ClientConnection::OnClosed on_closed);

  /// A live stream has moved on.
  void on_moment();
  /// More of a voice is there.
  void on_voice();
  /// {-2} to everybody, or to those that have come this way.
  void stop();
  void stop(Way way);
  /// Cuts off so many clients of level 2, the oldest first, for another server to take over. Spares
  /// those that were dialled from here, which could not come back.
  void send_away(std::size_t count);
  /// Closes all connections now.
  void abort();

  [[nodiscard]] std::size_t size() const { return clients_.size(); }
  [[nodiscard]] bool empty() const { return clients_.empty(); }
  /// Those that have come: all but the servers that were dialled from here.
  [[nodiscard]] std::size_t came() const { return clients_.size() - dialled_; }
  [[nodiscard]] std::size_t count(Way way) const;
  /// How many send_away() could cut off.
  [[nodiscard]] std::size_t count_movable() const;
  /// Fills in all that `status` says of clients.
  void describe(Status& status, Instant now) const;
  /// How many lines about clients the log left out, if any.
  void say_left_out() { log_.say_left_out(); }

 private:
  struct Client {
    std::shared_ptr<ClientConnection> connection;
    bool refused = false;  ///< it is read only to be told so; never for one that was dialled
    AddressKey address = 0;
    Way way = Way::Tcp;
  };

  [[nodiscard]] protocol::Admission admission_of(AddressKey address) const;
  void farewell(const ClientRecord& record);
  void for_each(const std::function<void(ClientConnection&)>& visit, std::optional<Way> way = {});

  const TransmitterOptions& options_;
  const std::size_t clients_max_;
  Stats& stats_;
  OnEmpty on_empty_;
  ClientConnection::OnPublisher on_publisher_;
  ClientLog log_;
  protocol::WrongTokens wrong_tokens_;
  std::map<std::uint64_t, Client> clients_;  ///< by number
  std::size_t refused_ = 0;                  ///< of those
  std::size_t dialled_ = 0;                  ///< likewise
  AddressCounts of_address_;                 ///< of the others
  std::uint64_t last_number_ = 0;
  std::uint64_t unheard_ = 0;
};

}  // namespace aucast::server
