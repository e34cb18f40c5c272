#include "common/link/web_link.h"

#include <optional>
#include <utility>

#include "common/link/layer_link.h"
#include "common/web/layer.h"

namespace aucast::link {
namespace {

using Why = Ending::Why;

class WebLink final : public LayerLink<web::Layer> {
 public:
  WebLink(std::shared_ptr<Link> below, std::string answer, const Limits& limits)
      : LayerLink(std::move(below), web::Layer(limits.frame_bytes)),
        answer_(std::move(answer)),
        limits_(limits) {}

  void start(LinkUser& user) override {
    user_ = &user;
    below_->hand_over(*this);
    below_->wake_at(std::nullopt);
    below_->write(answer_);
    hear();
    user_->on_open();
  }
  void wake_at(std::optional<Instant> when) override {
    wake_at_ = when;
    arm_timer();
  }

  // === What the link below tells.

  void on_open() override {}  // it was open before

  void on_bytes(std::string_view wire) override {
    const auto alive = shared_from_this();
    hear();
    std::string text;
    const bool good = layer_.received(wire, text);
    if (!text.empty() && listening()) user_->on_bytes(text);
    flush();  // pongs, or the Close that answers the peer's
    if (!listening()) return;
    if (!good) {
      end({Why::WebSocketFailed, layer_.reason()});
      user_->on_failure(*ending_);
    } else if (layer_.ended()) {
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
    const Instant now = below_->now();
    if (look_at_ && now >= *look_at_) look_for_peer(now);
    if (listening() && wake_at_ && now >= *wake_at_) {
      wake_at_.reset();
      user_->on_time();
    }
    arm_timer();
  }

  void on_failure(const Ending& failure) override {
    const auto alive = shared_from_this();
    ending_ = failure;
    user_->on_failure(failure);
  }

 private:
  void arm_timer() {
    const bool sooner = wake_at_ && (!look_at_ || *wake_at_ < *look_at_);
    below_->wake_at(sooner ? wake_at_ : look_at_);
  }

  /// The time to look stays while the peer speaks: setting a timer for every answer would cost more
  /// than the answer.
  void hear() {
    heard_at_ = below_->now();
    if (limits_.ping_idle.count() == 0 || (look_at_ && !asked_)) return;
    asked_ = false;
    look_at_ = heard_at_ + limits_.ping_idle;
    arm_timer();
  }

  void look_for_peer(Instant now) {
    if (!listening()) {
      look_at_.reset();
    } else if (asked_) {
      look_at_.reset();
      end({Why::Lost, "the client does not answer a Ping"});
    } else if (const Instant due = heard_at_ + limits_.ping_idle; now < due) {
      look_at_ = due;
    } else if (below_->blocked()) {
      look_at_ = now + limits_.ping_idle;  // a Ping would wait too, and TCP itself looks there
    } else {
      asked_ = true;
      layer_.ping();
      flush();
      look_at_ = now + limits_.pong_time;
    }
  }

  /// The WebSocket has ended: drains what waits, then reports it.
  void end(Ending ending) {
    ending_ = std::move(ending);
    below_->finish();
  }

  const std::string answer_;
  const Limits limits_;
  std::optional<Instant> wake_at_;  ///< for the user
  std::optional<Instant> look_at_;  ///< for the peer
  Instant heard_at_;
  bool asked_ = false;  ///< a Ping was sent, and nothing has come since
};

}  // namespace

std::shared_ptr<Link> web_link(std::shared_ptr<Link> below, std::string answer,
                               const Limits& limits) {
  return std::make_shared<WebLink>(std::move(below), std::move(answer), limits);
}

}  // namespace aucast::link
