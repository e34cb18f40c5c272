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

/// Bytes that several connections may be sending at once.
using SharedBytes = std::shared_ptr<const std::string>;

/// A reply whose body may be large and is not copied.
struct SharedReply {
  web::HttpReply head;
  SharedBytes body;  ///< null: the body is in `head`
};

/// One request and its reply on a link. Instead of replying, the owner of the exchange may take the
/// link: release().
/// Thread: that of the link.
class HttpExchange final : public link::LinkUser,
                           public std::enable_shared_from_this<HttpExchange> {
 public:
  /// What the exchange leaves to its owner. Must outlive the exchange.
  struct Hooks {
    std::size_t head_bytes_max = 0;  ///< of a request
    std::function<void(HttpExchange&, const web::HttpRequest&)> on_request;
    /// The bytes are no valid request; the reply says why.
    std::function<void(HttpExchange&, const web::HttpReply&)> on_fault;
  };
  using OnOver = std::function<void(const HttpExchange&)>;

  HttpExchange(std::shared_ptr<link::Link> link, asio::ip::tcp::endpoint peer, const Hooks& hooks,
               OnOver on_over)
      : link_(std::move(link)),
        peer_(std::move(peer)),
        hooks_(hooks),
        on_over_(std::move(on_over)) {}
  ~HttpExchange() override;
  HttpExchange(const HttpExchange&) = delete;
  HttpExchange& operator=(const HttpExchange&) = delete;

  void start() { link_->start(*this); }
  /// Answers the request, or refuses it. A HEAD request gets no body.
  void reply(SharedReply reply);
  /// Gives the link to the caller; this exchange has then ended.
  [[nodiscard]] std::shared_ptr<link::Link> release() { return std::exchange(link_, nullptr); }
  [[nodiscard]] bool released() const { return link_ == nullptr; }

  /// Whether no answer has been given yet.
  [[nodiscard]] bool asking() const { return !replied_; }
  [[nodiscard]] const asio::ip::tcp::endpoint& peer() const { return peer_; }
  [[nodiscard]] Instant now() const { return link_->now(); }
  /// How many bytes have come: the request, and any after it.
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
  const OnOver on_over_;
  std::string request_;
  bool head_ = false;  ///< it is a HEAD request
  bool replied_ = false;
  SharedBytes body_;
  std::size_t sent_ = 0;  ///< how much of it was sent
};

/// The exchanges under way, in the order in which they began. When there are too many, one is
/// closed: the oldest on which no request has come, so that silent connections do not keep others
/// out; if there is none, the oldest of all.
/// Thread: that of the links.
class HttpExchanges {
 public:
  /// `most`: how many may be under way.
  HttpExchanges(std::size_t most, HttpExchange::Hooks hooks)
      : most_(most), hooks_(std::move(hooks)) {}
  HttpExchanges(const HttpExchanges&) = delete;
  HttpExchanges& operator=(const HttpExchanges&) = delete;

  void begin(std::shared_ptr<link::Link> link, const asio::ip::tcp::endpoint& peer);

 private:
  std::size_t most_;
  const HttpExchange::Hooks hooks_;
  std::vector<std::shared_ptr<HttpExchange>> exchanges_;
};

}  // namespace aucast::server
