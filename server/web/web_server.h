#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>

#include "common/link/link.h"
#include "common/link/listener.h"
#include "common/result.h"
#include "common/time.h"
#include "common/tls/context.h"
#include "server/http/http_exchanges.h"
#include "server/settings/transmitter_options.h"
#include "server/status/client_log.h"
#include "server/web/page_files.h"

namespace aucast::server {

/// --web: gives the page's files, and makes a WebSocket of a request for /aucast, on the loop that
/// serves the clients. One request per connection. Bounded: kWebConnectionsMax connections that are
/// no WebSocket, each with kHttpTimeMax and kWebHeadBytesMax for its request, and kWebStallTimeMax
/// in which the client must take some of the file; one more closes the oldest, but first those that
/// have sent no request.
/// Thread: that of the io_context, which must outlive it together with what the hooks refer to.
class WebServer {
 public:
  using OpenLink = std::function<std::shared_ptr<link::Link>()>;

  /// What it asks the transmitter.
  struct Hooks {
    /// The present certificate; nullopt: plain connections.
    std::function<const std::optional<tls::Context>&()> tls;
    /// What the system may hold back unsent for one client; 0: as much as it likes.
    std::function<int()> held_back_max;
    /// A WebSocket has come in. Opens the link, unless there is no room even to say so.
    std::function<void(const asio::ip::tcp::endpoint& peer, const OpenLink& open_link)> welcome;
  };

  /// `options`, with an address, must outlive it.
  WebServer(asio::io_context& io, const WebOptions& options, Hooks hooks);
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  /// Reads the page and listens; a missing page is logged. Unreadable, or Network error naming
  /// address, cause and what to do.
  [[nodiscard]] Result<void> open(bool shared);
  void start();
  /// Nobody is accepted any more.
  void stop() { listener_.stop(); }

  [[nodiscard]] const asio::ip::tcp::endpoint& endpoint() const { return listener_.endpoint(); }
  [[nodiscard]] std::uint64_t accept_failures() const { return listener_.failures(); }

 private:
  [[nodiscard]] Result<void> read_page();
  void answer(HttpExchange& exchange, const web::HttpRequest& request);
  void make_web_socket(HttpExchange& exchange, const web::HttpRequest& request);
  void refuse(HttpExchange& exchange, const web::HttpReply& why);
  [[nodiscard]] std::shared_ptr<link::Link> link_of(asio::ip::tcp::socket socket) const;
  [[nodiscard]] std::vector<std::string> names() const;

  link::Listener listener_;
  const WebOptions& options_;
  Hooks hooks_;
  PageFiles files_;
  ClientLog log_;
  HttpExchanges exchanges_;
};

}  // namespace aucast::server
