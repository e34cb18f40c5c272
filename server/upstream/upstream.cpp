#include "server/upstream/upstream.h"

#include <algorithm>
#include <chrono>
#include <random>
#include <system_error>
#include <utility>
#include <variant>

#include "common/link/host.h"
#include "common/log.h"
#include "protocol/limits.h"
#include "protocol/link_limits.h"
#include "server/streams/memory.h"

namespace aucast::server {
namespace {

using std::chrono::steady_clock;

/// For the name, the connection and TLS: the next parent shall not wait long for one that is dead.
constexpr Milliseconds kDialTimeMax{5'000};

RelayedStream::Options stream_options(const UpstreamOptions& options) {
  const std::string& name = options.address.stream;
  return {name, options.classic_min, std::min<Milliseconds>(options.wait, protocol::kStreamWaitMax),
          [name](std::uint64_t bytes) { return check_memory(name, bytes); }};
}

}  // namespace

Upstream::Upstream(asio::io_context& io, UpstreamOptions options, std::function<void()> on_moment)
    : options_(std::move(options)),
      on_moment_(std::move(on_moment)),
      stream_(stream_options(options_)),
      turns_(options_.address.hosts.size(), std::random_device{}()),
      dialler_(io),
      dial_timer_(io),
      wait_timer_(io),
      reasons_(options_.address.hosts.size()) {}

void Upstream::start() {
  silent_since_ = steady_clock::now();
  await_giving_up();
  dial();
}

void Upstream::stop() {
  stopped_ = true;
  dialler_.cancel();
  dial_timer_.cancel();
  wait_timer_.cancel();
  drop_parent();
}

protocol::ServedStream Upstream::stream() const {
  protocol::ServedStream served;
  served.name = options_.address.stream;
  served.upstream = stream_.shared();
  return served;
}

std::string Upstream::name() const {
  const std::string& known = stream_.shared()->name;
  return known.empty() ? "upstream" : known;
}

std::string Upstream::peer() const {
  const protocol::Endpoint& parent = options_.address.hosts[turns_.current()];
  return link::host_and_port(parent.host, parent.port);
}

void Upstream::dial() {
  const protocol::Endpoint& parent = options_.address.hosts[turns_.current()];
  link::DialOptions dial;
  dial.host = parent.host;
  dial.port = parent.port;
  dial.time_max = kDialTimeMax;
  dial.tls = options_.tls;
  dial.secret = !options_.token.empty();
  dial.secret_remedy = "use aucasts://";
  dial.limits = protocol::kLinkLimits;
  // Thrown when the system has no thread left.
  try {
    dialler_.dial(std::move(dial),
                  [this](link::Dialled dialled) { on_dialled(std::move(dialled)); });
  } catch (const std::system_error& failure) {
    try_next(failure.code().message() + "; the system is short of threads or files");
  }
}

void Upstream::on_dialled(link::Dialled dialled) {
  if (auto* const link = std::get_if<std::shared_ptr<link::Link>>(&dialled)) {
    begin(std::move(*link));
  } else {
    try_next("cannot be reached: " + std::get<link::DialFailure>(dialled).reason);
  }
}

void Upstream::begin(std::shared_ptr<link::Link> link) {
  ++connects_;
  parent_ = std::make_unique<Parent>(
      std::move(link), stream_, Parent::Introduction{options_.token, options_.id},
      Parent::Owner{[this] { on_moved_on(); },
                    [this](const Parent::Ending& end) { on_over(end); }});
  parent_->start();
}

void Upstream::on_moved_on() {
  if (!receiving_ && parent_->packets() > 0) {
    receiving_ = true;
    turns_.worked();
    wait_timer_.cancel();
    say_goes_on();
    ever_received_ = true;
    for (std::string& reason : reasons_) reason.clear();
  }
  on_moment_();
}

/// What a change of parents cost: nothing of a recorded stream, a hole in a live one.
void Upstream::say_goes_on() {
  if (!ever_received_) {
    spdlog::info("{}: {}, from {}", name(), stream_.live() ? "live" : "recorded", peer());
    return;
  }
  const double hole = seconds(steady_clock::now() - silent_since_);
  if (stream_.live()) {
    spdlog::warn("{}: goes on with {}; what was sent in {:.3f} s is missing", name(), peer(), hole);
  } else {
    spdlog::info("{}: goes on with {} where it was cut off, after {:.3f} s; nothing is missing",
                 name(), peer(), hole);
  }
}

void Upstream::on_over(const Parent::Ending& ending) {
  if (stopped_) return;
  drop_parent();
  if (std::exchange(receiving_, false)) {
    silent_since_ = steady_clock::now();
    await_giving_up();
    if (!ending.in_order) ++losses_;
  }
  if (stream_.whole()) {
    spdlog::info("{}: it is here whole, {} s", name(), seconds(stream_.place()));
    wait_timer_.cancel();
    return;
  }
  try_next(ending.reason);
}

void Upstream::drop_parent() {
  if (!parent_) return;
  packets_before_ += parent_->packets();
  bytes_before_ += parent_->bytes();
  parent_.reset();
}

/// Of a parent that fails in the same way again and again one line is enough.
void Upstream::try_next(const std::string& reason) {
  std::string& said = reasons_[turns_.current()];
  const auto level = said == reason ? spdlog::level::debug : spdlog::level::warn;
  said = reason;
  const std::string failed = peer();
  const Milliseconds wait = turns_.next();
  spdlog::log(level, "{}: {}: {}; {} is tried in {:.1f} s", name(), failed, reason, peer(),
              seconds(wait));
  dial_timer_.expires_after(wait);
  dial_timer_.async_wait([this](const std::error_code& error) {
    if (!error && !stopped_) dial();
  });
}

void Upstream::await_giving_up() {
  wait_timer_.expires_at(silent_since_ + options_.wait);
  wait_timer_.async_wait([this](const std::error_code& error) {
    if (!error && !stopped_ && !receiving_ && !stream_.whole()) give_up();
  });
}

void Upstream::give_up() {
  spdlog::warn("{}: no parent sends it: {} (--upstream-wait {})", name(),
               ever_received_ ? "it ends for the clients there" : "who asks for it is told so",
               seconds(options_.wait));
  stream_.give_up();
  on_moment_();
}

UpstreamStatus Upstream::status() const {
  UpstreamStatus status;
  status.stream = stream_.shared()->name;
  status.parent = parent_ ? peer() : "";
  status.receiving = receiving_;
  status.connects = connects_;
  status.losses = losses_;
  status.packets = packets_before_ + (parent_ ? parent_->packets() : 0);
  status.bytes = bytes_before_ + (parent_ ? parent_->bytes() : 0);
  return status;
}

}  // namespace aucast::server
