#include "server/engine/follower.h"

#include <algorithm>
#include <utility>

#include "common/text.h"
#include "protocol/decoder.h"
#include "protocol/server_chain.h"

namespace aucast::server {

using protocol::EngineMessage;

std::vector<Follower::Event> Follower::take_events() {
  return std::exchange(events_, {});
}

std::vector<Follower::Event> Follower::on_connected(Instant now) {
  connected_ = true;
  ask_times_.reset(now);
  want(now);
  return take_events();
}

std::vector<Follower::Event> Follower::on_broadcast(std::string_view bytes, Instant now) {
  auto message = protocol::parse_engine_message(bytes);
  if (!message) {
    complain(garbage_, "a message on the subject is no batch: " + message.error().message, now);
  } else if (message->kind != EngineMessage::Kind::Batch) {
    complain(garbage_, "a message on the subject is no batch: it is an answer", now);
  } else {
    take_batch(*std::move(message), now);
  }
  return take_events();
}

std::vector<Follower::Event> Follower::on_answer(std::string_view bytes, Instant now) {
  // The server of NATS itself answers so when nobody is there who could.
  if (bytes.empty()) return {};
  auto message = protocol::parse_engine_message(bytes);
  if (!message) {
    complain(garbage_, "an answer makes no sense: " + message.error().message, now);
  } else if (!asking_) {
    // Several origins answer who asks all of them: the first one counts.
    if (message->origin != origin_) {
      complain_of_other(message->origin, now);
    }
  } else if (message->kind == EngineMessage::Kind::State) {
    take_state(*message, now);
  } else if (message->kind == EngineMessage::Kind::Since) {
    take_since(*message, now);
  }
  return take_events();
}

void Follower::take_batch(Message message, Instant now) {
  if (!origin_) {
    keep(std::move(message));
    ask_times_.on_somebody(now);
    want(now);
    return;
  }
  if (message.origin != *origin_) {
    complain_of_other(message.origin, now);
    return;
  }
  heard_at_ = now;
  if (message.seq <= last_) return;
  if (message.seq == last_ + 1) {
    pass(message);
    drain();
    if (waiting_.empty()) answered(now);
    ask_times_.on_gone_on(now);
  } else {
    keep(std::move(message));
    want(now);
  }
}

/// Why a state that was asked for cannot be used; nullopt: it can.
std::optional<std::string> Follower::objection(const Message& state) const {
  protocol::ServerPacketDecoder decoder;
  std::string_view bytes = state.packets;
  const auto packet = decoder.next(bytes);
  const auto* const hello = packet ? std::get_if<protocol::HelloGranted>(&*packet) : nullptr;
  if (hello == nullptr) return "its hello makes no sense";
  if (!hello->live) return "it is not live";
  if (protocol::passes_through(hello->servers, id_)) return "it would be this server's own again";
  return std::nullopt;
}

void Follower::take_state(const Message& message, Instant now) {
  if (origin_ && message.origin != *origin_) return;
  if (const auto wrong = objection(message)) {
    complain(refused_, "origin " + message.origin + " is not followed: " + *wrong, now);
    return;
  }
  if (origin_) {
    if (message.seq < last_) return;
    events_.emplace_back(Lose{"more is missing than origin " + *origin_ + " still has"});
  }
  origin_ = message.origin;
  last_ = message.seq;
  base_ms_ = message.place_ms;
  heard_at_ = now;
  ask_times_.on_begun(now);
  events_.emplace_back(
      Begin{message.origin, protocol::with_places_earlier(message.packets, base_ms_)});
  drain();
  answered(now);
}

void Follower::take_since(const Message& message, Instant now) {
  if (message.origin != origin_ || message.after != last_) return;
  heard_at_ = now;
  pass(message);
  drain();
  answered(now);
}

void Follower::pass(const Message& message) {
  last_ = message.seq;
  std::string packets = protocol::with_places_earlier(message.packets, base_ms_);
  if (!packets.empty()) events_.emplace_back(GoOn{std::move(packets)});
}

/// Passes on the waiting batches that follow the last one.
void Follower::drain() {
  std::stable_sort(waiting_.begin(), waiting_.end(),
                   [](const Message& a, const Message& b) { return a.seq < b.seq; });
  while (!waiting_.empty()) {
    const Message& next = waiting_.front();
    const bool ours = next.origin == origin_;
    if (ours && next.seq > last_ + 1) return;
    if (ours && next.seq == last_ + 1) pass(next);
    waiting_bytes_ -= next.packets.size();
    waiting_.pop_front();
  }
}

void Follower::keep(Message message) {
  waiting_bytes_ += message.packets.size();
  waiting_.push_back(std::move(message));
  while (waiting_.size() > kWaitingMax || waiting_bytes_ > kWaitingBytesMax) {
    waiting_bytes_ -= waiting_.front().packets.size();
    waiting_.pop_front();
    ++left_out_;
  }
}

void Follower::forget() {
  origin_.reset();
  waiting_.clear();
  waiting_bytes_ = 0;
}

std::vector<Follower::Event> Follower::on_over(Instant now) {
  forget();
  want(now);
  return take_events();
}

/// Asks now, or as soon as it may.
void Follower::want(Instant now) {
  asking_ = true;
  if (!connected_ || now < ask_times_.next()) return;
  protocol::EngineJoin join;
  if (origin_) {
    join.origin = *origin_;
    join.after = last_;
  }
  events_.emplace_back(Ask{encode(join)});
  ask_times_.on_asked(now);
}

/// Ends the request. Batches that still wait are dropped; if any are missing, the next batch shows
/// it.
void Follower::answered(Instant now) {
  asking_ = false;
  waiting_.clear();
  waiting_bytes_ = 0;
  ask_times_.on_answered(now);
}

std::vector<Follower::Event> Follower::on_time(Instant now) {
  if (origin_ && now >= heard_at_ + kSilence) {
    events_.emplace_back(Lose{"nothing has come from origin " + *origin_ + " for " +
                              std::to_string(kSilence.count()) + " ms"});
    forget();
    want(now);
  }
  if (asking_ && now >= ask_times_.next()) want(now);
  return take_events();
}

std::optional<Instant> Follower::deadline() const {
  std::optional<Instant> first;
  if (asking_ && connected_) first = ask_times_.next();
  if (origin_) first = std::min(first.value_or(heard_at_ + kSilence), heard_at_ + kSilence);
  return first;
}

void Follower::complain_of_other(const std::string& origin, Instant now) {
  complain(other_origin_, "origin " + origin + " sends it too and is left out", now);
}

void Follower::complain(RecurringComplaint& complaint, const std::string& text, Instant now) {
  const auto times = complaint.happened(now);
  if (!times) return;
  const std::string more = *times > 1 ? " (" + std::to_string(*times) + " so far)" : "";
  events_.emplace_back(Say{escaped(text, 200) + more});
}

}  // namespace aucast::server
