#include "server/upstream/upstream.h"

#include <memory>
#include <utility>

namespace aucast::server {
namespace {

Reception::Options reception_options(const UpstreamOptions& options) {
  return {options.from.address.stream, options.id, options.wait, options.classic_min};
}

}  // namespace

Upstream::Upstream(asio::io_context& io, UpstreamOptions options, std::function<void()> on_moment)
    : options_(std::move(options)),
      reception_(io, reception_options(options_),
                 {std::move(on_moment), [this] { redialler_.worked(); },
                  [this](const Parent::Ending& ending) { on_over(ending); }}),
      redialler_(
          io, {options_.from.address.hosts, options_.from.tls, !options_.from.token.empty()},
          [this] { return reception_.name(); },
          [this](std::shared_ptr<link::Link> link) {
            reception_.begin(std::move(link), redialler_.peer(), options_.from.token);
          }) {}

void Upstream::start() {
  reception_.start();
  redialler_.dial();
}

void Upstream::stop() {
  redialler_.stop();
  reception_.stop();
}

void Upstream::on_over(const Parent::Ending& ending) {
  if (!reception_.whole()) redialler_.failed(ending.reason);
}

}  // namespace aucast::server
