#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>

#include "common/link/link.h"
#include "common/link/listener.h"
#include "common/result.h"
#include "server/serve/client_registry.h"
#include "server/serve/credentials.h"
#include "server/serve/programme.h"
#include "server/settings/transmitter_options.h"
#include "server/web/web_server.h"

namespace aucast::server {

/// Accepts clients: at --port, at --web, and at a port for guests while --preview is live.
/// Thread: that of the io_context. What is passed by reference must outlive this object.
class Listeners {
 public:
  /// `certificates` is read for each connection, and may change.
  Listeners(asio::io_context& io, const TransmitterOptions& options,
            const Certificates& certificates, Programme& programme, ClientRegistry& clients);
  Listeners(const Listeners&) = delete;
  Listeners& operator=(const Listeners&) = delete;

  /// Listens at --port, or on the socket that the service manager passed, and at --web. Fails with
  /// Network and a message that names address, cause and remedy, with Unreadable if the page of
  /// --web cannot be read, or with Usage if two of --port, --web and --http have one port.
  [[nodiscard]] Result<void> open();
  /// Begins to accept connections.
  void start();
  /// Lets guests in at this numeric address, instead of any earlier one. Returns ADDR:PORT with the
  /// real port.
  [[nodiscard]] Result<std::string> open_to_guests(const std::string& bind, std::uint16_t port);
  void close_to_guests() { guests_.stop(); }
  /// Accepts no more clients.
  void close();

  /// Where --port listens; only after open().
  [[nodiscard]] const asio::ip::tcp::endpoint& endpoint() const { return tcp_.endpoint(); }
  /// Whether only the program that started us with --preview is served at --port; only after
  /// open().
  [[nodiscard]] bool only_for_owner() const;
  /// Where --web listens, as ADDR:PORT; empty: there is no --web.
  [[nodiscard]] std::string web_endpoint_text() const;
  /// How many times accepting had to pause.
  [[nodiscard]] std::uint64_t accept_failures() const;

 private:
  [[nodiscard]] Result<void> check_ports(bool passed) const;
  [[nodiscard]] Result<void> open_tcp();
  [[nodiscard]] Result<void> open_web();
  void accept_from(link::Listener& listener, ClientRegistry::Way way);
  void welcome(const asio::ip::tcp::endpoint& peer, const ClientRegistry::OpenLink& open_link,
               ClientRegistry::Way way);
  [[nodiscard]] std::shared_ptr<link::Link> link_of(asio::ip::tcp::socket socket,
                                                    ClientRegistry::Way way) const;

  asio::io_context& io_;
  const TransmitterOptions& options_;
  const Certificates& certificates_;
  Programme& programme_;
  ClientRegistry& clients_;
  link::Listener tcp_;
  link::Listener guests_;
  std::optional<WebServer> web_;
};

}  // namespace aucast::server
