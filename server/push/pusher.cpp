#include "server/push/pusher.h"

#include <utility>
#include <variant>

#include "common/log.h"
#include "common/random_digits.h"
#include "server/settings/limits.h"

namespace aucast::server {

using protocol::PublishSession;

Pusher::Pusher(asio::io_context& io, DialledAddress to, int held_back_max, Hooks hooks)
    : to_(std::move(to)),
      id_(random_digits(kIdDigits)),
      hooks_(std::move(hooks)),
      redialler_(
          io,
          {to_.address.hosts, to_.tls, !to_.token.empty(), held_back_max,
           [this] { return ready(); }},
          [this] { return name(); },
          [this](std::shared_ptr<link::Link> link) { introduce(std::move(link)); }) {}

void Pusher::stop() {
  redialler_.stop();
  introduction_.reset();
}

const protocol::ServedStream* Pusher::stream() const {
  return hooks_.stream(to_.address.stream);
}

/// While there is nothing to send, no server is dialled.
bool Pusher::ready() const {
  const protocol::ServedStream* const offered = stream();
  if (offered == nullptr) return false;
  return offered->live() ? !offered->live()->ended() : offered->recorded() != nullptr;
}

std::string Pusher::name() const {
  return "push " + stream_name();
}

std::string Pusher::stream_name() const {
  if (!to_.address.stream.empty()) return to_.address.stream;
  const protocol::ServedStream* const offered = stream();
  return offered == nullptr ? std::string() : offered->known_name();
}

std::string Pusher::substitute() const {
  const protocol::ServedStream* const offered = stream();
  if (offered == nullptr || offered->known_name() == stream_name()) return {};
  return "; it is the first stream, '" + offered->known_name() + "', as none here is called '" +
         stream_name() + "'";
}

void Pusher::introduce(std::shared_ptr<link::Link> link) {
  introduction_ = std::make_unique<Introduction>(
      std::move(link), PublishSession({stream_name(), to_.token, id_}),
      [this](const PublishSession::Answer& answer) { on_answer(answer); });
  introduction_->start();
}

void Pusher::on_answer(const PublishSession::Answer& answer) {
  const auto introduction = std::move(introduction_);
  if (const auto* failed = std::get_if<PublishSession::Failed>(&answer)) {
    redialler_.failed(failed->reason);
    return;
  }
  ++connects_;
  serving_ = true;
  spdlog::log(std::exchange(said_, true) ? spdlog::level::debug : spdlog::level::info,
              "{}: taken by {}{}", name(), redialler_.peer(), substitute());
  hooks_.serve(
      to_.address.stream, redialler_.peer(), introduction->release(),
      std::get<PublishSession::Taken>(answer).bytes,
      [this](const ClientRecord& record, const std::string& why) { on_served(record, why); });
}

void Pusher::on_served(const ClientRecord& record, const std::string& why) {
  serving_ = false;
  const bool finished = record.end_reason == ClientEnd(protocol::CloseConnection::Why::Finished);
  // Who has the whole stream already is sent nothing.
  if (finished || record.sent.keyframes > 0) redialler_.worked();
  if (record.sent.keyframes > 0) said_ = false;
  if (finished) {
    if (record.sent.keyframes > 0)
      spdlog::info("{}: {} has it to its end", name(), redialler_.peer());
    const bool live = stream() != nullptr && stream()->live();
    redialler_.again_in(live ? Redialler::kNotReady : kOfferAgain);
  } else {
    ++losses_;
    redialler_.failed(why);
  }
}

PushStatus Pusher::status() const {
  PushStatus status;
  status.stream = stream_name();
  status.server = redialler_.peer();
  status.sending = serving_;
  status.connects = connects_;
  status.losses = losses_;
  return status;
}

}  // namespace aucast::server
