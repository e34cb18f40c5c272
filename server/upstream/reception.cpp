#include "server/upstream/reception.h"

#include <algorithm>
#include <chrono>
#include <string_view>
#include <utility>

#include "common/log.h"
#include "common/memory.h"
#include "protocol/limits.h"

namespace aucast::server {
namespace {

using std::chrono::steady_clock;

constexpr std::string_view kRelayLess = "relay a shorter stream, or from a host with more memory";

RelayedStream::Options stream_options(const Reception::Options& options) {
  const std::string& name = options.name;
  return {name, options.classic_min, std::min<Milliseconds>(options.wait, protocol::kStreamWaitMax),
          [name](std::uint64_t bytes) { return check_memory(name, bytes, kRelayLess); },
          options.take_name};
}

}  // namespace

Reception::Reception(asio::io_context& io, Options options, Events events)
    : options_(std::move(options)),
      events_(std::move(events)),
      stream_(stream_options(options_)),
      timer_(io) {}

void Reception::start() {
  state_ = State::Waiting;
  silent_since_ = steady_clock::now();
  await_giving_up();
}

void Reception::stop() {
  state_ = State::Stopped;
  timer_.cancel();
  drop_parent();
}

std::string Reception::name() const {
  const std::string& known = stream_.shared()->name;
  return known.empty() ? "upstream" : known;
}

void Reception::begin(std::shared_ptr<link::Link> link, std::string peer,
                      const std::string& token) {
  connect(std::move(link), std::move(peer), {token, options_.id});
  parent_->start();
}

void Reception::take_over(std::shared_ptr<link::Link> link, std::string peer) {
  connect(std::move(link), std::move(peer), {"", options_.id, true});
  parent_->take_over();
}

void Reception::connect(std::shared_ptr<link::Link> link, std::string peer,
                        const Parent::Greeting& greeting) {
  ++connects_;
  peer_ = std::move(peer);
  parent_ = std::make_unique<Parent>(
      std::move(link), stream_, greeting,
      Parent::Events{[this] { on_moved_on(); },
                     [this](const Parent::Outcome& outcome) { on_over(outcome); }});
}

void Reception::drop() {
  if (parent_) on_over({false, "another connection takes its place"});
}

void Reception::end() {
  stop();
  stream_.give_up();
  events_.on_moment();
}

void Reception::begin_anew() {
  stream_.give_up();
  stream_ = RelayedStream(stream_options(options_));
  ever_received_ = false;
  start();
}

void Reception::on_moved_on() {
  // A parent may repeat the end of what is here whole.
  const bool whole = state_ == State::Whole;
  if (state_ != State::Receiving && !whole && parent_->keyframes() > 0) {
    state_ = State::Receiving;
    timer_.cancel();
    say_goes_on();
    ever_received_ = true;
    events_.on_first();
  }
  events_.on_moment();
}

/// Logs what a change of parents cost: nothing of a recorded stream, a gap in a live one.
void Reception::say_goes_on() {
  if (!ever_received_) {
    spdlog::info("{}: {}, from {}", name(), stream_.live() ? "live" : "recorded", peer_);
    return;
  }
  const double hole = seconds(steady_clock::now() - silent_since_);
  if (stream_.live()) {
    spdlog::warn("{}: goes on with {}; what was sent in {:.3f} s is missing", name(), peer_, hole);
  } else {
    spdlog::info("{}: goes on with {} where it was cut off, after {:.3f} s; nothing is missing",
                 name(), peer_, hole);
  }
}

void Reception::on_over(const Parent::Outcome& outcome) {
  if (state_ == State::Stopped) return;
  drop_parent();
  if (state_ == State::Receiving) {
    state_ = State::Waiting;
    silent_since_ = steady_clock::now();
    await_giving_up();
    if (!outcome.in_order) ++losses_;
  } else if (state_ == State::GivenUp) {
    // Since its hello, clients have been waiting for what it would send.
    stream_.give_up();
    events_.on_moment();
  }
  if (stream_.whole() && state_ != State::Whole) {
    state_ = State::Whole;
    spdlog::info("{}: it is here whole, {} s", name(), seconds(stream_.place()));
    timer_.cancel();
  }
  events_.on_over(outcome);
}

void Reception::drop_parent() {
  if (!parent_) return;
  keyframes_before_ += parent_->keyframes();
  bytes_before_ += parent_->bytes();
  parent_.reset();
}

void Reception::await_giving_up() {
  timer_.at(silent_since_ + options_.wait, [this] {
    if (!stream_.whole()) give_up();
  });
}

void Reception::give_up() {
  state_ = State::GivenUp;
  spdlog::warn("{}: no {} sends it: {} (--upstream-wait {})", name(), options_.sender,
               ever_received_ ? "it ends for the clients there" : "who asks for it is told so",
               seconds(options_.wait));
  stream_.give_up();
  events_.on_moment();
  events_.on_given_up();
}

protocol::ServedStream Reception::served() const {
  return {options_.name, stream_.shared()};
}

UpstreamStatus Reception::status() const {
  UpstreamStatus status;
  status.stream = stream_.shared()->name;
  status.parent = parent_ ? peer_ : "";
  status.receiving = state_ == State::Receiving;
  status.connects = connects_;
  status.losses = losses_;
  status.keyframes = keyframes_before_ + (parent_ ? parent_->keyframes() : 0);
  status.bytes = bytes_before_ + (parent_ ? parent_->bytes() : 0);
  status.captions_left_out = stream_.captions_left_out();
  return status;
}

}  // namespace aucast::server
