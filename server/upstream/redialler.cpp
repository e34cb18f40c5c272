#include "server/upstream/redialler.h"

#include <random>
#include <utility>
#include <variant>

#include "common/link/host.h"
#include "common/log.h"
#include "protocol/connection_limits.h"
#include "server/settings/limits.h"
#include "server/upstream/repeated.h"

namespace aucast::server {

Redialler::Redialler(asio::io_context& io, Options options, std::function<std::string()> name,
                     OnLink on_link)
    : options_(std::move(options)),
      name_(std::move(name)),
      on_link_(std::move(on_link)),
      turns_(options_.hosts.size(), std::random_device{}()),
      dialler_(io),
      timer_(io),
      reasons_(options_.hosts.size()) {}

void Redialler::stop() {
  stopped_ = true;
  dialler_.cancel();
  timer_.cancel();
}

std::string Redialler::peer() const {
  const protocol::Endpoint& host = options_.hosts[turns_.current()];
  return link::host_and_port(host.host, host.port);
}

void Redialler::dial() {
  if (!options_.ready()) {
    again_in(kNotReady);
    return;
  }
  const protocol::Endpoint& host = options_.hosts[turns_.current()];
  link::DialOptions dial;
  dial.host = host.host;
  dial.port = host.port;
  dial.time_max = kDialTimeMax;
  dial.tls = options_.tls;
  dial.secret = options_.secret;
  dial.secret_remedy = "use aucasts://";
  dial.limits = protocol::kLinkLimits;
  dial.held_back_max = options_.held_back_max;
  dialler_.dial(std::move(dial), [this](link::Dialled dialled) { on_dialled(std::move(dialled)); });
}

void Redialler::on_dialled(link::Dialled dialled) {
  if (auto* const link = std::get_if<std::shared_ptr<link::Link>>(&dialled)) {
    on_link_(std::move(*link));
  } else {
    failed("cannot be reached: " + std::get<link::DialFailure>(dialled).reason);
  }
}

void Redialler::worked() {
  turns_.worked();
  for (std::string& reason : reasons_) reason.clear();
}

void Redialler::failed(const std::string& reason) {
  if (stopped_) return;
  const auto level = level_of(reason, reasons_[turns_.current()]);
  const std::string host = peer();
  const Milliseconds wait = turns_.next();
  spdlog::log(level, "{}: {}: {}; {} is tried in {:.1f} s", name_(), host, reason, peer(),
              seconds(wait));
  again_in(wait);
}

void Redialler::again_in(Milliseconds wait) {
  if (stopped_) return;
  timer_.after(wait, [this] { dial(); });
}

}  // namespace aucast::server
