#pragma once

#include <functional>
#include <memory>
#include <string_view>

#include "common/link/link.h"
#include "protocol/publish_session.h"

namespace aucast::server {

/// The beginning of a connection over which a stream is offered: runs a PublishSession on a link.
/// Thread: that of the link.
class Introduction final : public link::LinkUser {
 public:
  /// Called once, as the last thing that this object does; the callee may destroy it.
  using OnAnswer = std::function<void(const protocol::PublishSession::Answer&)>;

  Introduction(std::shared_ptr<link::Link> link, protocol::PublishSession session,
               OnAnswer on_answer);
  ~Introduction() override;
  Introduction(const Introduction&) = delete;
  Introduction& operator=(const Introduction&) = delete;

  void start() { link_->start(*this); }
  /// After the stream was taken: gives the link to the caller.
  [[nodiscard]] std::shared_ptr<link::Link> release();

 private:
  void on_open() override;
  void on_bytes(std::string_view bytes) override;
  void on_peer_end() override;
  void on_time() override;
  void on_closed(const link::Ending& ending) override;

  void answer(const protocol::PublishSession::Answer& answer);

  std::shared_ptr<link::Link> link_;  ///< null: released
  protocol::PublishSession session_;
  OnAnswer on_answer_;
};

}  // namespace aucast::server
