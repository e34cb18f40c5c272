#include "server/status/http_server.h"

#include <utility>

#include "common/link/tcp_link.h"
#include "common/log.h"
#include "common/web/origin.h"
#include "protocol/connection_limits.h"
#include "server/settings/limits.h"

namespace aucast::server {

using asio::ip::tcp;

HttpServer::HttpServer(asio::io_context& io, Answer answer)
    : listener_(io, kAcceptLimits),
      answer_(std::move(answer)),
      exchanges_(kHttpConnectionsMax,
                 {kHttpHeadBytesMax,
                  [this](HttpExchange& exchange, const web::HttpRequest& request) {
                    exchange.reply({this->answer(request), nullptr});
                  },
                  [](HttpExchange& exchange, const web::HttpReply& why) {
                    exchange.reply({why, nullptr});
                  }}) {}

web::HttpReply HttpServer::answer(const web::HttpRequest& request) const {
  if (web::is_own_host(request.field("host"), {bound_})) return answer_(request.path);
  return {.status = 421,
          .body = "this server does not answer for that host: use its IP address or localhost\n"};
}

Result<void> HttpServer::open(const std::string& address, std::uint16_t port, bool shared) {
  bound_ = address;
  if (auto opened = listener_.open(address, port, {"--http", "--http", shared}); !opened) {
    return opened;
  }
  spdlog::info("status at http://{}/", link::endpoint_text(listener_.endpoint()));
  if (!listener_.endpoint().address().is_loopback()) {
    spdlog::warn(
        "--http tells everybody who reaches that address how the transmitter is; 127.0.0.1:PORT "
        "tells only this host");
  }
  return {};
}

void HttpServer::start() {
  listener_.start([this](tcp::socket socket, const tcp::endpoint& peer) {
    exchanges_.begin(link::tcp_link(std::move(socket), protocol::kLinkLimits), peer);
  });
}

}  // namespace aucast::server
