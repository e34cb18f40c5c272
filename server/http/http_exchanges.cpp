#include "server/http/http_exchanges.h"

#include <algorithm>
#include <utility>

#include "server/settings/limits.h"

namespace aucast::server {
namespace {

/// How much of a body is written before it is checked whether the connection takes more.
constexpr std::size_t kPieceBytes = 16384;

}  // namespace

HttpExchange::~HttpExchange() {
  if (link_) link_->close();
}

void HttpExchange::on_open() {
  link_->wake_at(link_->now() + kHttpTimeMax);
}

void HttpExchange::on_bytes(std::string_view bytes) {
  if (replied_) return;
  const auto alive = shared_from_this();
  request_ += bytes;
  const auto progress = web::read_http_request(request_, hooks_.head_bytes_max);
  head_ = progress.head;
  if (progress.refusal) {
    hooks_.on_fault(*this, *progress.refusal);
  } else if (progress.request) {
    hooks_.on_request(*this, *progress.request);
  }
  if (released()) end();
}

void HttpExchange::on_peer_end() {
  if (!replied_) link_->finish();
}

void HttpExchange::reply(SharedReply reply) {
  replied_ = true;
  if (!reply.body) {
    link_->write(web::format_http_reply(reply.head, head_));
  } else {
    link_->write(web::format_http_head(reply.head, reply.body->size()));
    if (!head_) body_ = std::move(reply.body);
  }
  send_more();
}

/// Sends as much of the body as the link takes. The rest is not copied, however many clients want
/// it.
void HttpExchange::send_more() {
  if (!replied_) return;
  std::string_view rest = body_ ? std::string_view(*body_).substr(sent_) : std::string_view();
  while (!rest.empty() && !link_->blocked()) {
    const std::string_view piece = rest.substr(0, kPieceBytes);
    link_->write(piece);
    rest.remove_prefix(piece.size());
    sent_ += piece.size();
  }
  if (rest.empty()) {
    link_->finish();
  } else {
    link_->wake_at(link_->now() + kWebStallTimeMax);
  }
}

void HttpExchange::end() {
  const auto alive = shared_from_this();
  on_over_(*this);
}

void HttpExchanges::begin(std::shared_ptr<link::Link> link, const asio::ip::tcp::endpoint& peer) {
  if (exchanges_.size() >= most_) {
    const auto silent = std::find_if(exchanges_.begin(), exchanges_.end(),
                                     [](const auto& exchange) { return exchange->asking(); });
    exchanges_.erase(silent == exchanges_.end() ? exchanges_.begin() : silent);
  }
  exchanges_.push_back(std::make_shared<HttpExchange>(
      std::move(link), peer, hooks_, [this](const HttpExchange& over) {
        std::erase_if(exchanges_,
                      [&over](const auto& exchange) { return exchange.get() == &over; });
      }));
  exchanges_.back()->start();
}

}  // namespace aucast::server
