#include "server/serve/shutdown.h"

#include <csignal>
#include <string>
#include <utility>

#include "common/log.h"
#include "common/text.h"

namespace aucast::server {

Shutdown::Shutdown(asio::io_context& io, Milliseconds drain_time, ClientRegistry& clients,
                   Hooks hooks)
    : signals_(io, SIGINT, SIGTERM),
      timer_(io),
      drain_time_(drain_time),
      clients_(clients),
      hooks_(std::move(hooks)),
      departure_(
          io, [this](std::size_t count) { clients_.send_away(count); },
          [this] {
            // Those who were not streaming yet when they were counted.
            clients_.send_away(clients_.size());
            stop("--drain-time is over");
          }) {}

void Shutdown::await_signal() {
  signals_.async_wait([this](const std::error_code& error, int number) {
    if (error) return;
    on_signal(number);
    await_signal();
  });
}

void Shutdown::on_signal(int number) {
  const char* name = number == SIGINT ? "SIGINT" : "SIGTERM";
  if (phase_ == Phase::Stopping) {
    spdlog::info("{} again: ending at once", name);
    clients_.abort();
  } else if (phase_ == Phase::Serving && drain_time_.count() > 0 && clients_.came() > 0) {
    leave(name);
  } else {
    stop(name);
  }
}

void Shutdown::leave(const char* why) {
  phase_ = Phase::Leaving;
  const std::size_t movable = clients_.count_movable();
  const std::size_t others = clients_.came() - movable;
  spdlog::info("{}: sending {} to other servers within {} s{}", why, counted(movable, "client"),
               seconds(drain_time_),
               others == 0 ? "" : fmt::format("; {} cannot be sent", counted(others, "other")));
  hooks_.on_leave(drain_time_ + kStopTimeMax);
  departure_.begin(movable, drain_time_);
}

void Shutdown::stop(const char* why) {
  if (phase_ == Phase::Stopping) return;
  phase_ = Phase::Stopping;
  departure_.stop();
  spdlog::info("{}: ending the stream of {}", why, counted(clients_.count_going_on(), "client"));
  hooks_.on_stop();
  clients_.stop();
  if (clients_.empty()) {
    hooks_.on_end();
    return;
  }
  timer_.after(kStopTimeMax, [this] { clients_.abort(); });
}

void Shutdown::on_empty() {
  if (phase_ == Phase::Stopping && clients_.empty()) {
    hooks_.on_end();
  } else if (phase_ == Phase::Leaving) {
    // Not now: what tells us may be a part of a stream that stops.
    timer_.after({}, [this] { stop("all clients are gone"); });
  }
}

}  // namespace aucast::server
