#include "server/status/http_server.h"

#include <utility>

#include "common/link/tcp_link.h"
#include "common/web/exchange_list.h"
#include "common/web/origin.h"
#include "protocol/link_limits.h"

namespace aucast::server {

using asio::ip::tcp;

/// One request and its reply.
class HttpServer::Exchange final : public link::LinkUser,
                                   public std::enable_shared_from_this<Exchange> {
 public:
  Exchange(tcp::socket socket, HttpServer& server)
      : link_(link::tcp_link(std::move(socket), protocol::kLinkLimits)), server_(server) {}
  ~Exchange() override { link_->close(); }
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;

  void start() { link_->start(*this); }

  /// The request has not come yet.
  [[nodiscard]] bool asking() const { return !replied_; }

 private:
  void on_open() override { link_->wake_at(link_->now() + protocol::kHttpTimeMax); }

  void on_bytes(std::string_view bytes) override {
    request_ += bytes;
    const web::HttpProgress progress =
        web::read_http_request(request_, protocol::kHttpHeadBytesMax);
    if (progress.refusal) {
      reply(*progress.refusal, false);
    } else if (progress.request) {
      reply(answer(*progress.request), progress.request->head);
    }
  }

  void on_peer_end() override { link_->finish(); }
  void on_room() override {}
  void on_time() override { end(); }
  void on_closed(const link::Ending&) override { end(); }

  [[nodiscard]] web::HttpReply answer(const web::HttpRequest& request) const {
    if (web::is_own_host(request.field("host"), {server_.bound_}))
      return server_.answer_(request.path);
    return {.status = 421,
            .body = "this server does not answer for that host: use its IP address or localhost\n"};
  }

  void reply(const web::HttpReply& reply, bool head) {
    replied_ = true;
    link_->write(web::format_http_reply(reply, head));
    link_->finish();
  }

  void end() {
    const auto alive = shared_from_this();
    std::erase(server_.exchanges_, alive);
  }

  std::shared_ptr<link::Link> link_;
  HttpServer& server_;
  std::string request_;
  bool replied_ = false;
};

HttpServer::HttpServer(asio::io_context& io, Answer answer)
    : listener_(io, protocol::kAcceptLimits), answer_(std::move(answer)) {}

HttpServer::~HttpServer() = default;

Result<void> HttpServer::open(const std::string& address, std::uint16_t port, bool shared) {
  bound_ = address;
  return listener_.open(address, port, {"--http", "--http", shared});
}

void HttpServer::start() {
  listener_.start([this](tcp::socket socket, const tcp::endpoint&) { welcome(std::move(socket)); });
}

void HttpServer::welcome(tcp::socket socket) {
  web::make_room(exchanges_, protocol::kHttpConnectionsMax);
  exchanges_.push_back(std::make_shared<Exchange>(std::move(socket), *this));
  exchanges_.back()->start();
}

}  // namespace aucast::server
