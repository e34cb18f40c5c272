#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include <asio/io_context.hpp>

#include "common/link/listener.h"
#include "common/result.h"
#include "common/web/http.h"
#include "server/http/http_exchanges.h"

namespace aucast::server {

/// Answers GET on the event loop that serves the clients, one request per connection. There are at
/// most kHttpConnectionsMax connections (HttpExchanges), each with kHttpTimeMax and
/// kHttpHeadBytesMax for its request. Requests for other hosts are refused with 421.
/// Thread: that of the io_context. The io_context and the callback's captures must outlive the
/// HttpServer.
class HttpServer {
 public:
  using Answer = std::function<web::HttpReply(const std::string& path)>;

  HttpServer(asio::io_context& io, Answer answer);
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  /// `shared`: other processes share the port. Logs where it listens. Fails with a Network error
  /// that names address, cause and remedy.
  [[nodiscard]] Result<void> open(const std::string& address, std::uint16_t port, bool shared);
  void start();
  /// Accepts no more connections.
  void stop() { listener_.stop(); }

 private:
  [[nodiscard]] web::HttpReply answer(const web::HttpRequest& request) const;

  link::Listener listener_;
  Answer answer_;
  std::string bound_;  ///< the address or name at which we listen
  HttpExchanges exchanges_;
};

}  // namespace aucast::server
