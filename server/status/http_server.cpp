#include "server/status/http_server.h"

#include <algorithm>
#include <array>
#include <utility>

#include <asio/buffer.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/steady_timer.hpp>
#include <asio/write.hpp>

#include "protocol/limits.h"

namespace aucast::server {

using asio::ip::tcp;

/// What the exchanges need of their server; they may live a handler longer than it.
struct HttpServer::Shared {
  Answer answer;
  std::string bound;  ///< the address or name that we listen on
};

/// One request and its reply.
class HttpServer::Exchange : public std::enable_shared_from_this<Exchange> {
 public:
  Exchange(tcp::socket socket, std::shared_ptr<Shared> shared)
      : socket_(std::move(socket)), timer_(socket_.get_executor()), shared_(std::move(shared)) {}

  void start() {
    timer_.expires_after(protocol::kHttpTimeMax);
    timer_.async_wait([self = shared_from_this()](const std::error_code& error) {
      if (!error) self->close();
    });
    read();
  }

  /// The request has not come yet.
  [[nodiscard]] bool asking() const { return output_.empty(); }

  void close() {
    std::error_code ignored;
    timer_.cancel();
    socket_.close(ignored);
  }

 private:
  void read() {
    socket_.async_read_some(
        asio::buffer(input_),
        [self = shared_from_this()](const std::error_code& error, std::size_t bytes) {
          if (error) {
            self->close();
          } else {
            self->on_read(bytes);
          }
        });
  }

  void on_read(std::size_t bytes) {
    request_.append(input_.data(), bytes);
    const HttpProgress progress = read_http_request(request_);
    if (progress.refusal) {
      reply(*progress.refusal, false);
    } else if (progress.request) {
      reply(answer(*progress.request), progress.request->head);
    } else {
      read();
    }
  }

  [[nodiscard]] HttpReply answer(const HttpRequest& request) const {
    if (is_own_host(request.host, shared_->bound)) return shared_->answer(request.path);
    return {421, HttpReply().type,
            "this server does not answer for that host: use its IP address or localhost\n"};
  }

  void reply(const HttpReply& reply, bool head) {
    output_ = format_http_reply(reply, head);
    asio::async_write(socket_, asio::buffer(output_),
                      [self = shared_from_this()](const std::error_code& error, std::size_t) {
                        if (error) {
                          self->close();
                        } else {
                          self->finish();
                        }
                      });
  }

  /// What the client still says is read and dropped until it ends or the time does: closing at once
  /// could reset the connection before it has read the reply.
  void finish() {
    std::error_code ignored;
    socket_.shutdown(tcp::socket::shutdown_send, ignored);
    drop();
  }

  void drop() {
    socket_.async_read_some(
        asio::buffer(input_),
        [self = shared_from_this()](const std::error_code& error, std::size_t bytes) {
          self->dropped_ += bytes;
          if (error || self->dropped_ > protocol::kHttpHeadBytesMax) {
            self->close();
          } else {
            self->drop();
          }
        });
  }

  tcp::socket socket_;
  asio::steady_timer timer_;
  std::shared_ptr<Shared> shared_;
  std::array<char, 1024> input_{};
  std::string request_;
  std::string output_;
  std::size_t dropped_ = 0;
};

HttpServer::HttpServer(asio::io_context& io, Answer answer)
    : listener_(io), shared_(std::make_shared<Shared>(Shared{std::move(answer), {}})) {}

HttpServer::~HttpServer() = default;

Result<void> HttpServer::open(const std::string& address, std::uint16_t port) {
  shared_->bound = address;
  return listener_.open(address, port, {"--http", "--http"});
}

void HttpServer::start() {
  listener_.start([this](tcp::socket socket, const tcp::endpoint&) { welcome(std::move(socket)); });
}

void HttpServer::welcome(tcp::socket socket) {
  std::erase_if(exchanges_, [](const auto& held) { return held.expired(); });
  if (exchanges_.size() >= protocol::kHttpConnectionsMax) {
    // One that says nothing must not keep others out.
    const auto asking = [](const auto& held) {
      const auto exchange = held.lock();
      return exchange && exchange->asking();
    };
    const auto silent = std::find_if(exchanges_.begin(), exchanges_.end(), asking);
    const auto oldest = silent == exchanges_.end() ? exchanges_.begin() : silent;
    if (const auto exchange = oldest->lock()) exchange->close();
    exchanges_.erase(oldest);
  }
  const auto exchange = std::make_shared<Exchange>(std::move(socket), shared_);
  exchanges_.push_back(exchange);
  exchange->start();
}

}  // namespace aucast::server
