#include "server/serve/client_registry.h"

#include <algorithm>

#include "common/link/listener.h"
#include "common/log.h"
#include "server/settings/limits.h"

namespace aucast::server {

void ClientRegistry::welcome(const asio::ip::tcp::endpoint& peer,
                             std::shared_ptr<const protocol::ServerCatalogue> catalogue,
                             const OpenLink& open_link, Way way) {
  const AddressKey address = address_key(peer.address());
  const protocol::Admission admission = admission_of(address, way);
  const bool refused =
      admission == protocol::Admission::Full || admission == protocol::Admission::FullAddress;
  if (refused && refused_ >= kRefusalsMax) {
    ++unheard_;
    spdlog::debug("a client too many was not even heard: {}", link::endpoint_text(peer));
    return;
  }
  const std::uint64_t number = ++last_number_;
  ++connects_;
  auto connection = std::make_shared<ClientConnection>(
      open_link(), std::move(catalogue),
      ClientConnection::Settings{.number = number,
                                 .peer = link::endpoint_text(peer),
                                 .log = &log_,
                                 .client_timeout = options_.client_timeout,
                                 .admission = admission,
                                 .batch = options_.batch,
                                 .token_count = protocol::TokenCount{&wrong_tokens_, address},
                                 .silence = way == Way::WebSocket ? protocol::Silence::Refused
                                                                  : protocol::Silence::Classic,
                                 .on_publisher = on_publisher_},
      [this](const ClientRecord& record, const std::string&) { farewell(record); });
  if (refused) {
    ++refused_;
  } else {
    of_address_.add(address);
  }
  clients_.emplace(number, Client{connection, refused, address, way});
  connection->start();
}

void ClientRegistry::serve(std::string peer,
                           std::shared_ptr<const protocol::ServerCatalogue> catalogue,
                           std::shared_ptr<link::Link> link, std::string_view bytes,
                           ClientConnection::OnClosed on_closed) {
  const std::uint64_t number = ++last_number_;
  ClientConnection::Settings settings;
  settings.number = number;
  settings.peer = std::move(peer);
  settings.client_timeout = options_.client_timeout;
  settings.batch = options_.batch;
  auto connection = std::make_shared<ClientConnection>(
      std::move(link), std::move(catalogue), std::move(settings),
      [this, told = std::move(on_closed)](const ClientRecord& record, const std::string& why) {
        farewell(record);
        told(record, why);
      });
  ++dialled_;
  clients_.emplace(number, Client{connection, false, 0, Way::Dialled});
  connection->take_over(bytes);
}

protocol::Admission ClientRegistry::admission_of(AddressKey address, Way way) const {
  const std::size_t inside = clients_.size() - refused_ - dialled_;
  if (inside >= clients_max_) return protocol::Admission::Full;
  const std::size_t most = options_.max_clients_per_address;
  if (most != 0 && of_address_.count(address) >= most) return protocol::Admission::FullAddress;
  return way == Way::Owner ? protocol::Admission::Owner : protocol::Admission::Welcome;
}

void ClientRegistry::farewell(const ClientRecord& record) {
  const auto client = clients_.find(record.number);
  if (client->second.way == Way::Dialled) {
    stats_.add_pushed(record);
    --dialled_;
  } else {
    stats_.add(record);
    if (client->second.refused) {
      --refused_;
    } else {
      of_address_.remove(client->second.address);
    }
  }
  clients_.erase(client);
  if (came() == 0) on_empty_();
}

/// A client may leave while it is visited; the others stay.
void ClientRegistry::for_each(const std::function<void(ClientConnection&)>& visit,
                              std::optional<Way> way) {
  for (auto next = clients_.begin(); next != clients_.end();) {
    const Client client = (next++)->second;
    if (!way || client.way == *way) visit(*client.connection);
  }
}

std::size_t ClientRegistry::count(Way way) const {
  return static_cast<std::size_t>(std::count_if(
      clients_.begin(), clients_.end(),
      [way](const auto& client) { return client.second.way == way && !client.second.refused; }));
}

std::size_t ClientRegistry::count_going_on() const {
  return static_cast<std::size_t>(
      std::count_if(clients_.begin(), clients_.end(), [](const auto& client) {
        return client.second.way != Way::Dialled && client.second.connection->goes_on();
      }));
}

std::size_t ClientRegistry::count_movable() const {
  return static_cast<std::size_t>(
      std::count_if(clients_.begin(), clients_.end(), [](const auto& client) {
        return client.second.way != Way::Dialled && client.second.connection->movable();
      }));
}

void ClientRegistry::on_voice() {
  for_each([](ClientConnection& connection) { connection.on_voice(); });
}

void ClientRegistry::on_moment() {
  for_each([](ClientConnection& connection) { connection.on_moment(); });
}

void ClientRegistry::stop() {
  for_each([](ClientConnection& connection) { connection.stop(); });
}

void ClientRegistry::send_away(std::size_t count) {
  for (auto next = clients_.begin(); next != clients_.end() && count > 0;) {
    const Client client = (next++)->second;
    if (client.way != Way::Dialled && client.connection->send_away()) --count;
  }
}

void ClientRegistry::stop(Way way) {
  for_each([](ClientConnection& connection) { connection.stop(); }, way);
}

void ClientRegistry::abort() {
  for_each([](ClientConnection& connection) { connection.abort(); });
}

void ClientRegistry::describe(Status& status, Instant now) const {
  status.clients = came();
  status.connects = connects_;
  status.connects_unheard = unheard_;
  status.disconnects = stats_.end_reasons();
  status.totals = stats_.totals();
  status.wrong_tokens = wrong_tokens_.shown();
  for (const auto& [number, client] : clients_) {
    const ClientConnection& connection = *client.connection;
    status.totals.add(connection.so_far());
    const bool is_client = client.way != Way::Dialled;
    if (client.way == Way::WebSocket) ++status.clients_web;
    if (is_client && connection.paused()) ++status.clients_paused;
    if (const auto since = connection.unsent_since()) {
      if (is_client) ++status.clients_behind;
      status.queue_seconds = std::max(status.queue_seconds, seconds(now - *since));
    }
    status.queue_bytes += connection.output_bytes();
  }
}

}  // namespace aucast::server
