#include "server/serve/transmitter.h"

#include <chrono>
#include <csignal>
#include <optional>
#include <string>
#include <utility>

#include <asio/io_context.hpp>
#include <asio/signal_set.hpp>

#include "common/link/listener.h"
#include "common/log.h"
#include "common/text.h"
#include "server/engine/engine_origin.h"
#include "server/engine/nats_bus.h"
#include "server/engine/nats_options.h"
#include "server/preview/preview.h"
#include "server/push/pushers.h"
#include "server/serve/client_registry.h"
#include "server/serve/listeners.h"
#include "server/serve/programme.h"
#include "server/serve/shutdown.h"
#include "server/status/http_routes.h"
#include "server/status/http_server.h"
#include "server/status/service_beat.h"
#include "server/status/status.h"

namespace aucast::server {
namespace {

/// One run: connects listeners, programme, clients, status and shutdown.
class Transmitter {
 public:
  Transmitter(const TransmitterOptions& options, Repertoire repertoire, Stats& stats,
              Reload::Load load)
      : options_(options),
        other_signals_(io_, SIGHUP, SIGUSR1),
        service_(io_, [this] { return summary(); }),
        clients_(
            options, stats, [this] { shutdown_.on_empty(); },
            [this](std::shared_ptr<link::Link> link, const protocol::HelloAsked& hello,
                   std::string peer) { programme_.take(std::move(link), hello, std::move(peer)); }),
        programme_(io_, options, std::move(repertoire),
                   {[this] { on_moment(); }, [this] { shutdown_.stop("all sources have ended"); },
                    [this] { clients_.on_voice(); },
                    options.preview ? [this](const camera::Sight& sight) { preview_->offer(sight); }
                                    : camera::OnSight()}),
        pushers_(io_, {[this](const std::string& name) { return programme_.named_or_first(name); },
                       [this](const auto& name, auto peer, auto link, auto bytes, auto on_served) {
                         clients_.serve(std::move(peer), programme_.alone(name), std::move(link),
                                        bytes, std::move(on_served));
                       }}),
        reload_(io_, options.credentials, certificates_, programme_, std::move(load),
                [this](const Reload::Outcome& outcome) { on_reloaded(outcome); }),
        listeners_(io_, options, certificates_, programme_, clients_),
        shutdown_(io_, options.drain_time, clients_,
                  {[this](Milliseconds at_most) { on_leave(at_most); }, [this] { on_stop(); },
                   [this] { end(); }}),
        routes_([this](Instant now) { return status(now); }) {}

  Result<RunResult> run(const OnReady& on_ready) {
    if (auto read = reload_.read_credentials(); !read) return read.error();
    if (auto opened = listeners_.open(); !opened) return opened.error();
    if (auto opened = open_http(); !opened) return opened.error();
    if (auto opened = open_preview(); !opened) return opened.error();
    shutdown_.await_signal();
    const auto sources = programme_.open_sources([this] { return stops_meanwhile(); });
    if (stopping()) return result();
    if (!sources) return sources.error();
    if (auto opened = open_engine_origin(); !opened) return opened.error();
    const auto pushers = pushers_.open(options_.push, programme_.held_back_max());
    if (!pushers) return pushers.error();
    ReadyAt where{link::endpoint_text(listeners_.endpoint()), listeners_.web_endpoint_text()};
    if (listeners_.only_for_owner()) where.owner_token = programme_.catalogue()->owner_token;
    if (auto ready = on_ready(where); !ready) return ready.error();
    say_who_can_connect();
    begin_ = std::chrono::steady_clock::now();
    await_other_signal();
    programme_.begin();
    if (engine_origin_) engine_origin_->on_moment();
    listeners_.start();
    if (http_) http_->start();
    pushers_.start();
    service_.begin();
    io_.run();
    clients_.say_left_out();
    return result();
  }

 private:
  /// Writes what the camera of --preview sees; the program that started us may let others in and
  /// send them away.
  Result<void> open_preview() {
    if (!options_.preview) return {};
    preview_.emplace(
        io_,
        Preview::Hooks{
            [this](const std::string& bind, std::uint16_t port) { return go_live(bind, port); },
            [this] { go_private(); }, [this] { return clients_.count(ClientRegistry::Way::Guest); },
            [this] { shutdown_.stop("the preview's reader has gone"); }});
    return preview_->start();
  }

  Result<std::string> go_live(const std::string& bind, std::uint16_t port) {
    go_private();
    return listeners_.open_to_guests(bind, port);
  }

  void go_private() {
    listeners_.close_to_guests();
    clients_.stop(ClientRegistry::Way::Guest);
  }

  Result<void> open_http() {
    if (!options_.http) return {};
    http_.emplace(io_, [this](const std::string& path) {
      return routes_.answer(path, stopping(), std::chrono::steady_clock::now());
    });
    return http_->open(options_.http->address, options_.http->port, options_.reuse_port);
  }

  Result<void> open_engine_origin() {
    if (options_.engine.publish.empty()) return {};
    const auto nats = nats_options(options_.engine.publish, options_.engine);
    if (!nats) return nats.error();
    engine_origin_.emplace(io_, EngineOrigin::Options{nats->address.stream, options_.batch},
                           [this] { return programme_.catalogue(); });
    return engine_origin_->start(
        [this, &nats](Bus::Events events) { return open_nats_bus(io_, *nats, std::move(events)); });
  }

  void on_moment() {
    clients_.on_moment();
    if (engine_origin_) engine_origin_->on_moment();
  }

  void say_who_can_connect() const {
    if (listeners_.endpoint().address().is_loopback()) {
      spdlog::info("only programs on this host can connect; --bind 0.0.0.0 lets others in");
    } else if (!programme_.catalogue()->token.empty() && !certificates_.tcp) {
      spdlog::warn("without --tls-cert everybody on the way can read the token");
    }
  }

  /// The status in one line, for the service manager.
  [[nodiscard]] std::string summary() const {
    return counted(clients_.came(), "client") + ", " +
           counted(programme_.catalogue()->streams.size(), "stream");
  }

  [[nodiscard]] Status status(Instant now) const {
    Status status;
    status.up_seconds = seconds(now - begin_);
    status.stopping = stopping();
    status.accept_failures = listeners_.accept_failures();
    status.reloads = reload_.successes();
    status.reload_failures = reload_.failures();
    programme_.describe(status);
    clients_.describe(status, now);
    pushers_.describe(status);
    if (engine_origin_) engine_origin_->describe(status);
    return status;
  }

  void await_other_signal() {
    other_signals_.async_wait([this](const std::error_code& error, int number) {
      if (error) return;
      if (number == SIGHUP) {
        spdlog::info("SIGHUP: reading certificates, token and sources again");
        service_.reloading();
        reload_.start();
      } else {
        const Status now = status(std::chrono::steady_clock::now());
        for (const std::string& line : status_lines(now)) spdlog::info("{}", line);
      }
      await_other_signal();
    });
  }

  void on_reloaded(const Reload::Outcome& outcome) {
    if (outcome.changed) {
      spdlog::info("serving {} now; for the {} here nothing changes",
                   counted(programme_.catalogue()->streams.size(), "stream"),
                   counted(clients_.came(), "client"));
    }
    // Who asked for the next one waits for what that reads.
    if (outcome.last) service_.reloaded();
  }

  /// Whether we are to stop. While a camera is awaited the loop does not run yet, so signals are
  /// handled here.
  bool stops_meanwhile() {
    io_.poll();
    return stopping();
  }

  [[nodiscard]] bool stopping() const { return shutdown_.phase() != Shutdown::Phase::Serving; }

  /// Accepts no more clients, and pushes no more streams.
  void close_doors(Milliseconds at_most) {
    service_.stopping(at_most);
    listeners_.close();
    pushers_.stop();
  }

  void on_leave(Milliseconds at_most) {
    close_doors(at_most);
    // Who shares its port answers monitors from now on.
    if (http_ && options_.reuse_port) http_->stop();
  }

  void on_stop() {
    close_doors({});
    if (preview_) preview_->stop();
    if (engine_origin_) engine_origin_->stop();
    reload_.stop();
    programme_.stop();
  }

  /// Lets io_.run() return, whatever it still waits for. Cancelling everything would not be enough:
  /// a handler that is queued already, such as for a SIGUSR1 together with the last signal, would
  /// begin to wait again.
  void end() { io_.stop(); }

  [[nodiscard]] RunResult result() {
    RunResult result;
    if (auto finished = programme_.finish(); !finished) result.error = finished.error();
    return result;
  }

  const TransmitterOptions& options_;
  asio::io_context io_{1};
  asio::signal_set other_signals_;
  ServiceBeat service_;
  std::optional<Preview> preview_;
  ClientRegistry clients_;
  Programme programme_;
  Certificates certificates_;
  Pushers pushers_;
  Reload reload_;
  Listeners listeners_;
  Shutdown shutdown_;
  HttpRoutes routes_;
  std::optional<EngineOrigin> engine_origin_;
  std::optional<HttpServer> http_;
  Instant begin_{};
};

}  // namespace

Result<RunResult> serve(const TransmitterOptions& options, Repertoire repertoire, Stats& stats,
                        const OnReady& on_ready, Reload::Load load) {
  std::signal(SIGPIPE, SIG_IGN);
  link::raise_descriptor_limit();
  return Transmitter(options, std::move(repertoire), stats, std::move(load)).run(on_ready);
}

}  // namespace aucast::server
