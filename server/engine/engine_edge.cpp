#include "server/engine/engine_edge.h"

#include <chrono>
#include <utility>
#include <variant>

#include "common/log.h"
#include "common/text.h"
#include "server/upstream/repeated.h"

namespace aucast::server {
namespace {

using std::chrono::steady_clock;

}  // namespace

EngineEdge::EngineEdge(asio::io_context& io, const Reception::Options& options, OpenBus open,
                       std::function<void()> on_moment)
    : name_(options.name),
      open_(std::move(open)),
      reception_(io, options,
                 {std::move(on_moment), [this] { reason_.clear(); },
                  [this](const Parent::Outcome& outcome) { on_over(outcome); }}),
      follower_(options.id),
      timer_(io) {}

Result<void> EngineEdge::start() {
  auto bus = open_({[this](const Bus::Message& message) { on_message(message); },
                    [this](const std::string& server) { on_connected(server); },
                    [this] { on_disconnected(); }});
  if (!bus) return bus.error();
  bus_ = *std::move(bus);
  bus_->subscribe(batch_subject(name_));
  bus_->subscribe(bus_->own_subject());
  reception_.start();
  return {};
}

void EngineEdge::stop() {
  stopped_ = true;
  timer_.cancel();
  bus_.reset();
  reception_.stop();
}

void EngineEdge::describe(Status& status) const {
  Upstream::describe(status);
  if (!status.engine) status.engine.emplace();
  if (bus_) status.engine->messages_left_out += bus_->left_out();
  status.engine->batches_left_out += follower_.left_out();
}

void EngineEdge::on_message(const Bus::Message& message) {
  if (stopped_) return;
  const Instant now = steady_clock::now();
  const bool answer = message.subject == bus_->own_subject();
  carry_out(answer ? follower_.on_answer(message.bytes, now)
                   : follower_.on_broadcast(message.bytes, now));
}

void EngineEdge::on_connected(const std::string& server) {
  if (stopped_) return;
  spdlog::info("{}: NATS at {}", name_, escaped(server));
  server_ = server;
  carry_out(follower_.on_connected(steady_clock::now()));
}

void EngineEdge::on_disconnected() {
  if (stopped_) return;
  spdlog::warn("{}: the connection to NATS at {} is lost", name_, escaped(server_));
  follower_.on_disconnected();
}

void EngineEdge::on_over(const Parent::Outcome& outcome) {
  over_ = true;
  spdlog::log(level_of(outcome.reason, reason_), "{}: {}", name_, outcome.reason);
}

void EngineEdge::carry_out(const std::vector<Follower::Event>& events) {
  for (const Follower::Event& event : events) {
    std::visit([this](const auto& what) { handle(what); }, event);
  }
  if (stopped_) return;
  // What the receiver has left by itself the follower does not know yet.
  if (std::exchange(over_, false)) {
    link_.reset();
    carry_out(follower_.on_over(steady_clock::now()));
    return;
  }
  wait();
}

void EngineEdge::handle(const Follower::Ask& event) {
  bus_->send({join_subject(name_), bus_->own_subject(), event.request});
}

void EngineEdge::handle(const Follower::Begin& event) {
  link_ = std::make_shared<JoinedLink>();
  reception_.begin(link_, event.origin + " over NATS at " + escaped(server_), "");
  link_->deliver(event.packets);
}

void EngineEdge::handle(const Follower::GoOn& event) {
  if (link_ && !over_) link_->deliver(event.packets);
}

void EngineEdge::handle(const Follower::Lose& event) {
  if (!link_) return;
  link_->lose(event.reason);
  link_.reset();
  over_ = false;
}

void EngineEdge::handle(const Follower::Say& event) {
  spdlog::warn("{}: {}", name_, event.text);
}

void EngineEdge::wait() {
  const auto deadline = follower_.deadline();
  if (!deadline) {
    timer_.cancel();
    return;
  }
  timer_.at(*deadline, [this] { carry_out(follower_.on_time(steady_clock::now())); });
}

}  // namespace aucast::server
