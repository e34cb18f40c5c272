#include "server/status/http_server.h"

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
  std::size_t open = 0;
};

/// One request and its reply.
class HttpServer::Exchange : public std::enable_shared_from_this<Exchange> {
 public:
  Exchange(tcp::socket socket, std::shared_ptr<Shared> shared)
      : socket_(std::move(socket)), timer_(socket_.get_executor()), shared_(std::move(shared)) {
    ++shared_->open;
  }
  ~Exchange() { --shared_->open; }
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;

  void start() {
    timer_.expires_after(protocol::kHttpTimeMax);
    timer_.async_wait([self = shared_from_this()](const std::error_code& error) {
      if (!error) self->close();
    });
    read();
  }

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
      reply(shared_->answer(progress.request->path), progress.request->head);
    } else {
      read();
    }
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
  return listener_.open(address, port, {"--http", "--http"});
}

void HttpServer::start() {
  listener_.start([this](tcp::socket socket, const tcp::endpoint&) {
    if (shared_->open >= protocol::kHttpConnectionsMax) return;  // the socket closes
    std::make_shared<Exchange>(std::move(socket), shared_)->start();
  });
}

}  // namespace aucast::server
