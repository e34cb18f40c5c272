#include "server/web/web_server.h"

#include <utility>

#include "common/files.h"
#include "common/link/tcp_link.h"
#include "common/link/tls_link.h"
#include "common/link/web_link.h"
#include "common/log.h"
#include "common/text.h"
#include "common/web/exchange_list.h"
#include "common/web/http.h"
#include "common/web/upgrade.h"
#include "protocol/link_limits.h"
#include "server/web/web_gate.h"

namespace aucast::server {

using asio::ip::tcp;

namespace {

constexpr std::string_view kWebSocketPath = "/aucast";

/// Of a file, between two looks at whether the connection takes more.
constexpr std::size_t kPieceBytes = 16384;

}  // namespace

/// One request and its reply, or what becomes a WebSocket.
class WebServer::Exchange final : public link::LinkUser,
                                  public std::enable_shared_from_this<Exchange> {
 public:
  Exchange(std::shared_ptr<link::Link> link, tcp::endpoint peer, WebServer& server)
      : link_(std::move(link)), peer_(std::move(peer)), server_(server) {}
  ~Exchange() override {
    if (link_) link_->close();
  }
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;

  void start() { link_->start(*this); }

  /// The request has not come yet.
  [[nodiscard]] bool asking() const { return !replied_; }

 private:
  void on_open() override { link_->wake_at(link_->now() + protocol::kHttpTimeMax); }

  void on_bytes(std::string_view bytes) override {
    if (replied_) return;
    request_ += bytes;
    const auto progress = web::read_http_request(request_, protocol::kWebHeadBytesMax);
    if (progress.refusal) {
      refuse(*progress.refusal);
    } else if (progress.request) {
      answer(*progress.request);
    }
  }

  void on_peer_end() override {
    if (!replied_) link_->finish();
  }
  void on_room() override { send_more(); }
  void on_time() override { end(); }
  void on_closed(const link::Ending&) override { end(); }

  void answer(const web::HttpRequest& request) {
    const std::vector<std::string> names = server_.names();
    if (const auto refused = refuse_host(request, names)) {
      refuse(*refused);
    } else if (request.path != kWebSocketPath) {
      reply(server_.files_.reply(request), request.head);
    } else if (const auto refused_too = refuse_web_socket(request, names)) {
      refuse(*refused_too);
    } else if (request.head_bytes != request_.size()) {
      refuse({.status = 400, .body = "a client waits for the answer before it says more\n"});
    } else {
      become_web_socket(request);
    }
  }

  void become_web_socket(const web::HttpRequest& request) {
    const auto alive = shared_from_this();
    const tcp::endpoint from{asker(request, peer_.address(), server_.options_.trusted_proxies),
                             peer_.port()};
    server_.hooks_.welcome(from, [this, &request] {
      return link::web_link(std::exchange(link_, nullptr), web::accept_upgrade(request),
                            protocol::kLinkLimits);
    });
    if (link_) {
      refuse({.status = 503, .body = "the server is full\n"});
    } else {
      end();
    }
  }

  void refuse(const web::HttpReply& why) {
    server_.log_.say(link_->now(), spdlog::level::info, "web {}: refused with {}: {}",
                     link::endpoint_text(peer_), why.status,
                     std::string_view(why.body).substr(0, why.body.find('\n')));
    reply({why, nullptr}, false);
  }

  void reply(PageReply reply, bool head) {
    replied_ = true;
    if (!reply.body) {
      link_->write(web::format_http_reply(reply.head, head));
    } else {
      link_->write(web::format_http_head(reply.head, reply.body->size()));
      if (!head) body_ = std::move(reply.body);
    }
    send_more();
  }

  /// So much of the body as is taken; the rest waits where it is, for however many ask.
  void send_more() {
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
      link_->wake_at(link_->now() + protocol::kWebStallTimeMax);
    }
  }

  void end() {
    const auto alive = shared_from_this();
    std::erase(server_.exchanges_, alive);
  }

  std::shared_ptr<link::Link> link_;  ///< null: it has become a WebSocket
  const tcp::endpoint peer_;
  WebServer& server_;
  std::string request_;
  bool replied_ = false;
  SharedBytes body_;
  std::size_t sent_ = 0;  ///< of it
};

WebServer::WebServer(asio::io_context& io, const WebOptions& options, Hooks hooks)
    : listener_(io, protocol::kAcceptLimits), options_(options), hooks_(std::move(hooks)) {}

WebServer::~WebServer() = default;

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
  listener_.start(
      [this](tcp::socket socket, const tcp::endpoint& peer) { welcome(std::move(socket), peer); });
}

void WebServer::welcome(tcp::socket socket, const tcp::endpoint& peer) {
  web::make_room(exchanges_, protocol::kWebConnectionsMax);
  exchanges_.push_back(std::make_shared<Exchange>(link_of(std::move(socket)), peer, *this));
  exchanges_.back()->start();
}

std::shared_ptr<link::Link> WebServer::link_of(tcp::socket socket) const {
  auto link = link::tcp_link(std::move(socket), protocol::kLinkLimits, hooks_.held_back_max());
  if (!hooks_.tls()) return link;
  return link::tls_link(
      std::move(link), tls::Channel(*hooks_.tls()), protocol::kLinkLimits,
      web::format_http_reply({.status = 400, .body = "this port speaks https and wss only\n"},
                             false));
}

/// What this server answers for beside addresses and localhost.
std::vector<std::string> WebServer::names() const {
  std::vector<std::string> names = options_.hosts;
  names.push_back(options_.address->address);
  if (hooks_.tls()) {
    for (std::string& name : hooks_.tls()->names()) names.push_back(std::move(name));
  }
  return names;
}

}  // namespace aucast::server
