#include "server/web/web_server.h"

#include <utility>

#include "common/files.h"
#include "common/link/tcp_link.h"
#include "common/link/tls_link.h"
#include "common/link/web_link.h"
#include "common/log.h"
#include "common/text.h"
#include "common/web/http.h"
#include "common/web/upgrade.h"
#include "protocol/connection_limits.h"
#include "server/settings/limits.h"
#include "server/web/web_gate.h"

namespace aucast::server {

using asio::ip::tcp;

namespace {

constexpr std::string_view kWebSocketPath = "/aucast";

/// Of a file, and of a WebSocket whose stream is recorded. The system tells of room when half of
/// this is gone: if it held megabytes, a slow client would seem to take nothing (kWebStallTimeMax).
constexpr int kHeldBackOfFiles = 65536;

}  // namespace

WebServer::WebServer(asio::io_context& io, const WebOptions& options, Hooks hooks)
    : listener_(io, kAcceptLimits),
      options_(options),
      hooks_(std::move(hooks)),
      exchanges_(
          kWebConnectionsMax,
          {kWebHeadBytesMax,
           [this](HttpExchange& exchange, const web::HttpRequest& request) {
             answer(exchange, request);
           },
           [this](HttpExchange& exchange, const web::HttpReply& why) { refuse(exchange, why); }}) {}

void WebServer::answer(HttpExchange& exchange, const web::HttpRequest& request) {
  const std::vector<std::string> known = names();
  if (const auto refused = refuse_host(request, known)) {
    refuse(exchange, *refused);
  } else if (request.path != kWebSocketPath) {
    exchange.reply(files_.reply(request));
  } else if (const auto refused_too = refuse_web_socket(request, known)) {
    refuse(exchange, *refused_too);
  } else if (request.head_bytes != exchange.bytes()) {
    refuse(exchange,
           {.status = 400, .body = "a client waits for the answer before it says more\n"});
  } else {
    make_web_socket(exchange, request);
  }
}

void WebServer::make_web_socket(HttpExchange& exchange, const web::HttpRequest& request) {
  const tcp::endpoint& peer = exchange.peer();
  const Asker from = asker(request, peer.address(), options_.trusted_proxies);
  if (!from.unread.empty() && !std::exchange(unread_said_, true)) {
    spdlog::warn(
        "web {}: X-Forwarded-For has '{}', which is no address: such clients count as one, the "
        "proxy",
        link::endpoint_text(peer), escaped(from.unread));
  }
  // The proxy does not say the client's port.
  const bool direct = from.address == peer.address();
  hooks_.welcome(direct ? peer : tcp::endpoint(from.address, 0), [&exchange, &request] {
    return link::web_link(exchange.release(), web::accept_upgrade(request), protocol::kLinkLimits);
  });
  if (!exchange.released()) refuse(exchange, {.status = 503, .body = "the server is full\n"});
}

void WebServer::refuse(HttpExchange& exchange, const web::HttpReply& why) {
  log_.say(exchange.now(), spdlog::level::info, "web {}: refused with {}: {}",
           link::endpoint_text(exchange.peer()), why.status,
           std::string_view(why.body).substr(0, why.body.find('\n')));
  exchange.reply({why, nullptr});
}

Result<void> WebServer::open(bool shared) {
  if (auto read = read_page(); !read) return read;
  return listener_.open(options_.address->address, options_.address->port,
                        {"--web", "--web", shared});
}

Result<void> WebServer::read_page() {
  const auto data = find_data_folder({});
  if (data) {
    auto files = PageFiles::read(*data / "web");
    if (!files) return files.error();
    files_ = std::move(*files);
  }
  if (files_.has_page()) {
    spdlog::info("the page has {}", counted(files_.size(), "file"));
  } else {
    spdlog::warn(
        "--web: there is no page in {}: scripts/build_web.sh builds it; WebSockets are served at "
        "{} without",
        data ? printable((*data / "web").string()) : "share/aucast/web", kWebSocketPath);
  }
  return {};
}

void WebServer::start() {
  listener_.start([this](tcp::socket socket, const tcp::endpoint& peer) {
    exchanges_.begin(link_of(std::move(socket)), peer);
  });
}

std::shared_ptr<link::Link> WebServer::link_of(tcp::socket socket) const {
  const int held_back = hooks_.held_back_max();
  auto link = link::tcp_link(std::move(socket), protocol::kLinkLimits,
                             held_back == 0 ? kHeldBackOfFiles : held_back);
  if (!hooks_.tls()) return link;
  return link::tls_link(
      std::move(link), tls::Layer(*hooks_.tls()), protocol::kLinkLimits,
      web::format_http_reply({.status = 400, .body = "this port speaks https and wss only\n"},
                             false));
}

/// The names under which this server answers, besides addresses and localhost.
std::vector<std::string> WebServer::names() const {
  std::vector<std::string> names = options_.hosts;
  names.push_back(options_.address->address);
  if (hooks_.tls()) {
    for (std::string& name : hooks_.tls()->names()) names.push_back(std::move(name));
  }
  return names;
}

}  // namespace aucast::server
