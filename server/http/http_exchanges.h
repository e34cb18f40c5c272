#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <asio/ip/tcp.hpp>

#include "common/link/link.h"
#include "common/time.h"
#include "common/web/http.h"

namespace aucast::server {

/// Bytes that several connections may be sending.
using SharedBytes = std::shared_ptr<const std::string>;

/// A reply whose body may be large: it is not copied.
struct SharedReply {
  web::HttpReply head;
  SharedBytes body;  ///< null: `head` has its own
};

/// One request and its reply on a link, or what becomes something else.
/// Thread: that of the link.
class HttpExchange final : public link::LinkUser,
                           public std::enable_shared_from_this<HttpExchange> {
 public:
  /// What it leaves to others; outlives it.
  struct Hooks {
    std::size_t head_bytes_max = 0;  ///< of a request
    std::function<void(HttpExchange&, const web::HttpRequest&)> on_request;
    /// What came is no request, for which this is the reply.
    std::function<void(HttpExchange&, const web::HttpReply&)> on_fault;
    std::function<void(const HttpExchange&)> on_over;
  };

  HttpExchange(std::shared_ptr<link::Link> link, asio::ip::tcp::endpoint peer, const Hooks& hooks)
      : link_(std::move(link)), peer_(std::move(peer)), hooks_(hooks) {}
  ~HttpExchange() override;
  HttpExchange(const HttpExchange&) = delete;
  HttpExchange& operator=(const HttpExchange&) = delete;

  void start() { link_->start(*this); }
  /// The answer to the request; of one for the head, only that.
  void reply(SharedReply reply, bool head);
  /// Gives the link to whoever goes on with it; this exchange is over.
  [[nodiscard]] std::shared_ptr<link::Link> release() { return std::exchange(link_, nullptr); }
  [[nodiscard]] bool released() const { return link_ == nullptr; }

  /// The request has not come yet.
  [[nodiscard]] bool asking() const { return !replied_; }
  [[nodiscard]] const asio::ip::tcp::endpoint& peer() const { return peer_; }
  [[nodiscard]] Instant now() const { return link_->now(); }
  /// Bytes that have come: the request, and what was said behind it.
  [[nodiscard]] std::size_t bytes() const { return request_.size(); }

 private:
  void on_open() override;
  void on_bytes(std::string_view bytes) override;
  void on_peer_end() override;
  void on_room() override { send_more(); }
  void on_time() override { end(); }
  void on_closed(const link::Ending&) override { end(); }

  void send_more();
  void end();

  std::shared_ptr<link::Link> link_;  ///< null: released
  const asio::ip::tcp::endpoint peer_;
  const Hooks& hooks_;
  std::string request_;
  bool replied_ = false;
  SharedBytes body_;
  std::size_t sent_ = 0;  ///< of it
};

/// The exchanges under way, in the order in which they came. One too many closes the oldest, but
/// first those that have sent no request: a silent connection must not keep others out.
/// Thread: that of the links.
class HttpExchanges {
 public:
  /// `hooks`, but for its on_over.
  HttpExchanges(std::size_t most, HttpExchange::Hooks hooks);
  HttpExchanges(const HttpExchanges&) = delete;
  HttpExchanges& operator=(const HttpExchanges&) = delete;

  void begin(std::shared_ptr<link::Link> link, const asio::ip::tcp::endpoint& peer);

 private:
  std::size_t most_;
  HttpExchange::Hooks hooks_;
  std::vector<std::shared_ptr<HttpExchange>> exchanges_;
};

}  // namespace aucast::server
