#include "server/upstream/parent.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "server/settings/limits.h"

namespace aucast::server {
namespace {

protocol::ClientSessionOptions session_options(const RelayedStream& stream,
                                               const Parent::Greeting& greeting) {
  protocol::ClientSessionOptions options;
  options.hello = stream.asked();
  options.hello.token = greeting.token;
  options.hello.relay = greeting.id;
  options.hello.takes = greeting.takes;
  return options;
}

std::string_view without_blanks_before(std::string_view packet) {
  return packet.substr(std::min(packet.find('{'), packet.size()));
}

}  // namespace

Parent::Parent(std::shared_ptr<link::Link> link, RelayedStream& stream, const Greeting& greeting,
               Events events)
    : link_(std::move(link)),
      stream_(stream),
      events_(std::move(events)),
      session_(session_options(stream, greeting)) {}

Parent::~Parent() {
  link_->close();
}

void Parent::take_over() {
  link_->hand_over(*this);
  on_open();
}

void Parent::on_open() {
  carry_out(session_.on_connected(link_->now()));
  settle();
}

void Parent::on_bytes(std::string_view bytes) {
  stream_.begin_call();
  while (!bytes.empty() && !outcome_) {
    const std::string_view before = bytes;
    const auto events = session_.on_bytes(bytes);
    packet_ += before.substr(0, before.size() - bytes.size());
    carry_out(events);
  }
  settle();
}

void Parent::on_peer_end() {
  carry_out(session_.on_closed());
  settle();
}

void Parent::on_time() {
  carry_out(session_.on_time(link_->now()));
  settle();
}

void Parent::on_closed(const link::Ending& ending) {
  if (!outcome_) outcome_ = Outcome{false, ending.reason};
  settle();
}

void Parent::carry_out(const std::vector<protocol::ClientEvent>& events) {
  for (const protocol::ClientEvent& event : events) {
    if (outcome_) return;
    std::visit([this](const auto& what) { handle(what); }, event);
  }
}

void Parent::handle(const protocol::SendBytes& event) {
  link_->write(event.bytes);
}

void Parent::handle(const protocol::Granted& event) {
  packet_.clear();
  leave(stream_.begin(event.hello));
  if (outcome_) outcome_->unfit = true;
  moved_on_ = true;
}

void Parent::handle(const protocol::DeliverKeyframe& event) {
  if (session_.level() != protocol::Level::Negotiated) {
    leave("it speaks classic only, and a relay needs level 2");
    return;
  }
  if (floods()) return;
  leave(stream_.add(event, without_blanks_before(packet_)));
  packet_.clear();
  answers_ += session_.answer_received();
  moved_on_ = true;
}

void Parent::handle(const protocol::DeliverVoice& event) {
  packet_.clear();
  if (floods()) return;
  leave(stream_.add(event));
  moved_on_ = true;
}

void Parent::handle(const protocol::DeliverCaption& event) {
  packet_.clear();
  if (floods()) return;
  leave(stream_.add(event));
  moved_on_ = true;
}

void Parent::handle(const protocol::StreamEnded& /*event*/) {
  leave(stream_.end());
  if (!outcome_) outcome_ = Outcome{true, "its stream has ended"};
  moved_on_ = true;
}

void Parent::handle(const protocol::ReconnectClassic& /*event*/) {
  leave("it took the hello for garbage or closed at once; is it an au-transmitter?");
}

void Parent::handle(const protocol::SessionFailed& event) {
  leave(event.reason);
}

void Parent::leave(std::optional<std::string> wrong) {
  if (wrong) outcome_ = Outcome{false, *std::move(wrong)};
}

/// Leaves a parent that sends more of a live stream than a face can need.
bool Parent::floods() {
  if (!stream_.live()) return false;
  const Instant now = link_->now();
  if (now - second_begin_ >= std::chrono::seconds(1)) {
    second_begin_ = now;
    in_second_ = 0;
  }
  if (++in_second_ <= kRelayedPerSecondMax) return false;
  leave("it sends more than " + std::to_string(kRelayedPerSecondMax) +
        " keyframes, voice packets and captions a second");
  return true;
}

/// Called at the end of every call from the link; nothing is done with this object afterwards.
void Parent::settle() {
  if (!answers_.empty()) link_->write(std::exchange(answers_, {}));
  link_->wake_at(session_.deadline());
  if (std::exchange(moved_on_, false)) events_.on_moved_on();
  if (!outcome_) return;
  const auto over = std::exchange(events_.on_over, nullptr);
  const Outcome outcome = *outcome_;
  if (over) over(outcome);
}

}  // namespace aucast::server
