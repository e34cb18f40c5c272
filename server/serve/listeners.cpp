#include "server/serve/listeners.h"

#include <string>
#include <utility>
#include <vector>

#include "common/link/tcp_link.h"
#include "common/link/tls_link.h"
#include "common/log.h"
#include "common/options.h"
#include "common/text.h"
#include "protocol/codec.h"
#include "protocol/connection_limits.h"
#include "server/settings/limits.h"
#include "server/status/service_manager.h"

namespace aucast::server {

using asio::ip::tcp;

Listeners::Listeners(asio::io_context& io, const TransmitterOptions& options,
                     const Certificates& certificates, Programme& programme,
                     ClientRegistry& clients)
    : io_(io),
      options_(options),
      certificates_(certificates),
      programme_(programme),
      clients_(clients),
      tcp_(io, kAcceptLimits),
      guests_(io, kAcceptLimits) {}

Result<void> Listeners::open() {
  if (auto opened = open_tcp(); !opened) return opened;
  return open_web();
}

/// With --reuse-port the system would let two listen at one port, and spread the clients of each
/// over both.
Result<void> Listeners::check_ports(bool passed) const {
  struct Wanted {
    const char* option;
    HttpAddress at;
  };
  std::vector<Wanted> all;
  if (!passed) all.push_back({"--port", {options_.bind, options_.port}});
  if (options_.web.address) all.push_back({"--web", *options_.web.address});
  if (options_.http) all.push_back({"--http", *options_.http});
  for (auto one = all.begin(); one != all.end(); ++one) {
    for (auto other = all.begin(); other != one; ++other) {
      if (one->at.port == 0 || one->at.port != other->at.port) continue;
      if (!link::overlap(one->at.address, other->at.address)) continue;
      return usage_error(std::string(other->option) + " and " + one->option + " have one port, " +
                         std::to_string(one->at.port) + ": give each a port of its own");
    }
  }
  return {};
}

Result<void> Listeners::open_tcp() {
  const auto passed = passed_socket();
  if (!passed) return passed.error();
  if (auto can = check_ports(passed->has_value()); !can) return can;
  if (!*passed) {
    return tcp_.open(options_.bind, options_.port, {"--bind", "--port", options_.reuse_port});
  }
  if (auto opened = tcp_.open_passed(**passed); !opened) return opened;
  spdlog::info("the service manager passed the socket; --bind and --port are idle");
  return {};
}

Result<void> Listeners::open_web() {
  if (!options_.web.address) return {};
  web_.emplace(io_, options_.web,
               WebServer::Hooks{
                   [this]() -> const std::optional<tls::Context>& { return certificates_.web; },
                   [this] { return programme_.held_back_max(); },
                   [this](const tcp::endpoint& peer, const ClientRegistry::OpenLink& open_link) {
                     welcome(peer, open_link, ClientRegistry::Way::WebSocket);
                   }});
  if (auto opened = web_->open(options_.reuse_port); !opened) return opened;
  const bool secure = certificates_.web.has_value();
  spdlog::info("browsers are served at {}://{}/", secure ? "https" : "http", web_endpoint_text());
  if (!secure && !web_->endpoint().address().is_loopback()) {
    spdlog::warn("without --web-cert everybody on the way can read and change what the page gets");
  }
  return {};
}

void Listeners::start() {
  accept_from(tcp_, only_for_owner() ? ClientRegistry::Way::Owner : ClientRegistry::Way::Tcp);
  if (web_) web_->start();
}

bool Listeners::only_for_owner() const {
  return options_.preview && tcp_.endpoint().address().is_loopback();
}

/// For messages: the fields of the window, since its user sets them there.
constexpr link::ListenOptions kGuestFields{"Address", "the number beside Address", false};

Result<std::string> Listeners::open_to_guests(const std::string& bind, std::uint16_t port) {
  guests_.stop();
  // A name would be looked up here, while others are served.
  std::error_code not_numbers;
  asio::ip::make_address(bind, not_numbers);
  if (not_numbers) {
    return Error{ErrorKind::Usage,
                 "'" + escaped(bind) + "' is no address in numbers, such as 0.0.0.0"};
  }
  if (auto opened = guests_.open(bind, port, kGuestFields); !opened) return opened.error();
  accept_from(guests_, ClientRegistry::Way::Guest);
  return link::endpoint_text(guests_.endpoint());
}

void Listeners::close() {
  tcp_.stop();
  guests_.stop();
  if (web_) web_->stop();
}

std::string Listeners::web_endpoint_text() const {
  return web_ ? link::endpoint_text(web_->endpoint()) : "";
}

std::uint64_t Listeners::accept_failures() const {
  return tcp_.failures() + guests_.failures() + (web_ ? web_->accept_failures() : 0);
}

void Listeners::accept_from(link::Listener& listener, ClientRegistry::Way way) {
  listener.start([this, way](tcp::socket socket, const tcp::endpoint& peer) {
    welcome(
        peer, [&] { return link_of(std::move(socket), way); }, way);
  });
}

void Listeners::welcome(const tcp::endpoint& peer, const ClientRegistry::OpenLink& open_link,
                        ClientRegistry::Way way) {
  // However many knock at once, those who watch are not kept waiting for them.
  programme_.catch_up();
  clients_.welcome(peer, programme_.catalogue(), open_link, way);
}

std::shared_ptr<link::Link> Listeners::link_of(tcp::socket socket, ClientRegistry::Way way) const {
  auto link = link::tcp_link(std::move(socket), protocol::kLinkLimits, programme_.held_back_max());
  const auto& tls = certificates_.tcp;
  if (!tls || way == ClientRegistry::Way::Owner) return link;
  return link::tls_link(
      std::move(link), tls::Layer(*tls), protocol::kLinkLimits,
      protocol::encode(protocol::ErrorReply{protocol::kMalformed,
                                            "this server speaks TLS only (face-player --tls)"}));
}

}  // namespace aucast::server
