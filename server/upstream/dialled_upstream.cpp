#include "server/upstream/dialled_upstream.h"

#include <memory>
#include <utility>

namespace aucast::server {

DialledUpstream::DialledUpstream(asio::io_context& io, DialledAddress from,
                                 Reception::Options options, std::function<void()> on_moment)
    : from_(std::move(from)),
      reception_(io, std::move(options),
                 {std::move(on_moment), [this] { redialler_.worked(); },
                  [this](const Parent::Outcome& outcome) { on_over(outcome); }}),
      redialler_(
          io, {from_.address.hosts, from_.tls, !from_.token.empty()},
          [this] { return reception_.name(); },
          [this](std::shared_ptr<link::Link> link) {
            reception_.begin(std::move(link), redialler_.peer(), from_.token);
          }) {}

Result<void> DialledUpstream::start() {
  reception_.start();
  redialler_.dial();
  return {};
}

void DialledUpstream::halt() {
  redialler_.stop();
  reception_.stop();
}

void DialledUpstream::on_over(const Parent::Outcome& outcome) {
  if (!reception_.whole()) redialler_.failed(outcome.reason);
}

}  // namespace aucast::server
