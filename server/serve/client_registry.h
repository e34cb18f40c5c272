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

/// All client connections, from accept to close, including those that are only told that there is
/// no room. Decides who is let in, and counts what was sent. Thread: that of the links.
class ClientRegistry {
 public:
  using OpenLink = std::function<std::shared_ptr<link::Link>()>;
  using OnEmpty = std::function<void()>;

  /// Of `options` only the limits and times of clients are used. `stats` gets the record of each
  /// client that leaves. Both must outlive it. `on_empty` is called when no client is left except
  /// servers that we have dialled, and again whenever one of these leaves. `on_publisher` is called
  /// when a client turns out to be a publisher, which then no longer counts as a client. `room`
  /// limits the number of clients if the options do not.
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

  /// How a client is connected.
  enum class Way : std::uint8_t {
    Tcp,
    Owner,  ///< over TCP: the program that started us with --preview, which shows its own token
    WebSocket,
    Dialled,  ///< we have dialled it (--push)
    Guest,    ///< over TCP, at the port that --preview opens for others while the Owner allows it
  };

  /// Takes a connection that has come in. If it must be refused while kRefusalsMax others are being
  /// refused, the link is not even opened.
  void welcome(const asio::ip::tcp::endpoint& peer,
               std::shared_ptr<const protocol::ServerCatalogue> catalogue,
               const OpenLink& open_link, Way way = Way::Tcp);

  /// Serves another server, which we have dialled and which takes our stream. `link` is open, and
  /// `bytes` have come on it. The limits on clients do not apply, and logging is left to
  /// `on_closed`.
  void serve(std::string peer, std::shared_ptr<const protocol::ServerCatalogue> catalogue,
             std::shared_ptr<link::Link> link, std::string_view bytes,
             ClientConnection::OnClosed on_closed);

  /// A stream has something new.
  void on_moment();
  /// A voice has grown.
  void on_voice();
  /// Ends the stream with {-2}, for all clients or for those that are connected in one way.
  void stop();
  void stop(Way way);
  /// Cuts off `count` clients of level 2, the oldest first, for another server to take over.
  /// Servers that we have dialled are not cut off, since they could not come back.
  void send_away(std::size_t count);
  /// Closes all connections at once.
  void abort();

  [[nodiscard]] std::size_t size() const { return clients_.size(); }
  [[nodiscard]] bool empty() const { return clients_.empty(); }
  /// How many of the present connections came in: all except those that we have dialled.
  [[nodiscard]] std::size_t came() const { return clients_.size() - dialled_; }
  [[nodiscard]] std::size_t count(Way way) const;
  /// How many connections that came in have neither been sent away nor ended.
  [[nodiscard]] std::size_t count_going_on() const;
  /// How many send_away() could cut off.
  [[nodiscard]] std::size_t count_movable() const;
  /// Fills in everything about clients.
  void describe(Status& status, Instant now) const;
  /// Logs how many lines about clients were left out, if any were.
  void say_left_out() { log_.say_left_out(); }

 private:
  struct Client {
    std::shared_ptr<ClientConnection> connection;
    bool refused = false;  ///< it is only told that there is no room; never true for Way::Dialled
    AddressKey address = 0;
    Way way = Way::Tcp;
  };

  [[nodiscard]] protocol::Admission admission_of(AddressKey address, Way way) const;
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
  std::size_t refused_ = 0;                  ///< how many of them are being refused
  std::size_t dialled_ = 0;                  ///< how many of them we have dialled
  AddressCounts of_address_;                 ///< of those neither refused nor dialled
  std::uint64_t last_number_ = 0;
  std::uint64_t connects_ = 0;  ///< connections that came in
  std::uint64_t unheard_ = 0;
};

}  // namespace aucast::server
