#include "server/push/introduction.h"

#include <utility>
#include <variant>

#include "common/link/host.h"
#include "server/settings/limits.h"

namespace aucast::server {

using protocol::PublishSession;

Introduction::Introduction(std::shared_ptr<link::Link> link, PublishSession session,
                           OnAnswer on_answer)
    : link_(std::move(link)), session_(std::move(session)), on_answer_(std::move(on_answer)) {}

Introduction::~Introduction() {
  if (link_) link_->close();
}

std::shared_ptr<link::Link> Introduction::release() {
  link_->wake_at(std::nullopt);
  return std::exchange(link_, nullptr);
}

void Introduction::on_open() {
  link_->write(session_.hello());
  link_->wake_at(link_->now() + kPublishAnswerTimeMax);
}

void Introduction::on_bytes(std::string_view bytes) {
  answer(session_.on_bytes(bytes));
}

void Introduction::on_peer_end() {
  answer(PublishSession::Failed{PublishSession::closed_reason()});
}

void Introduction::on_time() {
  answer(PublishSession::Failed{"nothing came from it within " +
                                link::time_text(kPublishAnswerTimeMax)});
}

void Introduction::on_closed(const link::Ending& ending) {
  answer(PublishSession::Failed{ending.reason});
}

void Introduction::answer(const PublishSession::Answer& answer) {
  if (!on_answer_ || std::holds_alternative<std::monostate>(answer)) return;
  const auto tell = std::exchange(on_answer_, nullptr);
  tell(answer);
}

}  // namespace aucast::server
