#include "common/link/web_link.h"

#include <optional>
#include <utility>

#include "common/link/channel_link.h"
#include "common/web/channel.h"

namespace aucast::link {
namespace {

using Why = Ending::Why;

class WebLink final : public ChannelLink<web::Channel> {
 public:
  WebLink(std::shared_ptr<Link> below, std::string answer, const Limits& limits)
      : ChannelLink(std::move(below), web::Channel(limits.frame_bytes)),
        answer_(std::move(answer)) {}

  void start(LinkUser& user) override {
    user_ = &user;
    below_->hand_over(*this);
    below_->wake_at(std::nullopt);
    below_->write(answer_);
    user_->on_open();
  }
  void wake_at(std::optional<Instant> when) override { below_->wake_at(when); }

  // === What the link below tells.

  void on_open() override {}  // it was open before

  void on_bytes(std::string_view wire) override {
    const auto alive = shared_from_this();
    std::string text;
    const bool good = channel_.received(wire, text);
    if (!text.empty() && listening()) user_->on_bytes(text);
    flush();  // pongs, or the Close that answers the peer's
    if (!listening()) return;
    if (!good) {
      end({Why::WebSocketFailed, channel_.reason()});
      user_->on_failure(*ending_);
    } else if (channel_.ended()) {
      end({Why::Lost, "the client closed the WebSocket"});
    }
  }

  void on_peer_end() override { end({Why::Lost, "the connection ended without a Close"}); }

  void on_room() override {
    const auto alive = shared_from_this();
    if (listening()) user_->on_room();
  }

  void on_time() override {
    const auto alive = shared_from_this();
    if (listening()) user_->on_time();
  }

  void on_failure(const Ending& failure) override {
    const auto alive = shared_from_this();
    ending_ = failure;
    user_->on_failure(failure);
  }

 private:
  /// The WebSocket is over; what waits is drained, then it is told.
  void end(Ending ending) {
    ending_ = std::move(ending);
    below_->finish();
  }

  const std::string answer_;
};

}  // namespace

std::shared_ptr<Link> web_link(std::shared_ptr<Link> below, std::string answer,
                               const Limits& limits) {
  return std::make_shared<WebLink>(std::move(below), std::move(answer), limits);
}

}  // namespace aucast::link
