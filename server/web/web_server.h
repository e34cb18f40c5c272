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

/// The server of --web: sends the page's files, and turns a request for /aucast into a WebSocket,
/// on the event loop that serves the clients. One request per connection. There are at most
/// kWebConnectionsMax connections that are no WebSocket (HttpExchanges), each with kHttpTimeMax and
/// kWebHeadBytesMax for its request, and kWebStallTimeMax in which the client must take some of the
/// file.
/// Thread: that of the io_context. The io_context and what the hooks refer to must outlive the
/// WebServer.
class WebServer {
 public:
  using OpenLink = std::function<std::shared_ptr<link::Link>()>;

  /// What it asks of the transmitter.
  struct Hooks {
    /// The present certificate; nullopt: no TLS.
    std::function<const std::optional<tls::Context>&()> tls;
    /// The `held_back_max` for link::tcp_link(), for each client.
    std::function<int()> held_back_max;
    /// A WebSocket has come in. The callee calls `open_link`, unless there is no room even for a
    /// refusal.
    std::function<void(const asio::ip::tcp::endpoint& peer, const OpenLink& open_link)> welcome;
  };

  /// `options`, which must have an address, must outlive it.
  WebServer(asio::io_context& io, const WebOptions& options, Hooks hooks);
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  /// Reads the page and listens; a missing page is logged. `shared`: other processes share the
  /// port. Fails with Unreadable for the page, or with a Network error that names address, cause
  /// and remedy.
  [[nodiscard]] Result<void> open(bool shared);
  void start();
  /// Accepts no more connections.
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
  bool unread_said_ = false;  ///< the log has said that a proxy does not name its clients
  HttpExchanges exchanges_;
};

}  // namespace aucast::server
