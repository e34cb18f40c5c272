#include "common/link/web_link.h"

#include <optional>
#include <utility>

#include "common/web/channel.h"

namespace aucast::link {
namespace {

using Why = Ending::Why;

/// Whatever is told from below keeps this alive until it is through, for the user may let go.
class WebLink final : public Link, public LinkUser, public std::enable_shared_from_this<WebLink> {
 public:
  WebLink(std::shared_ptr<Link> below, std::string answer, const Limits& limits)
      : below_(std::move(below)), channel_(limits.frame_bytes), answer_(std::move(answer)) {}
  ~WebLink() override { below_->close(); }

  // === What the user asks for.

  void start(LinkUser& user) override {
    user_ = &user;
    below_->hand_over(*this);
    below_->wake_at(std::nullopt);
    below_->write(answer_);
    user_->on_open();
  }
  void hand_over(LinkUser& user) override { user_ = &user; }
  void write(std::string_view bytes) override {
    if (ending_ || finishing_) return;
    channel_.send(bytes);
    flush();
  }
  void finish() override {
    if (ending_ || std::exchange(finishing_, true)) return;
    channel_.end();
    flush();
    below_->finish();
  }
  void close() override {
    user_ = nullptr;
    below_->close();
  }
  void set_reading(bool reading) override { below_->set_reading(reading); }
  void wake_at(std::optional<Instant> when) override { below_->wake_at(when); }
  [[nodiscard]] Instant now() const override { return below_->now(); }
  [[nodiscard]] Duration round_trip() const override { return below_->round_trip(); }
  [[nodiscard]] bool blocked() const override { return below_->blocked(); }
  [[nodiscard]] std::optional<Instant> stuck_since() const override {
    return below_->stuck_since();
  }
  [[nodiscard]] std::size_t unsent_bytes() const override { return below_->unsent_bytes(); }
  [[nodiscard]] std::uint64_t wire_bytes() const override { return below_->wire_bytes(); }

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

  void on_closed(const Ending& ending) override {
    const auto alive = shared_from_this();
    LinkUser* const user = std::exchange(user_, nullptr);
    user->on_closed(ending_.value_or(ending));
  }

 private:
  /// The user wants to know.
  [[nodiscard]] bool listening() const { return user_ != nullptr && !finishing_ && !ending_; }

  void flush() {
    if (const std::string wire = channel_.take_output(); !wire.empty()) below_->write(wire);
  }

  /// The WebSocket is over; what waits is drained, then it is told.
  void end(Ending ending) {
    ending_ = std::move(ending);
    below_->finish();
  }

  std::shared_ptr<Link> below_;
  web::Channel channel_;
  const std::string answer_;
  LinkUser* user_ = nullptr;
  bool finishing_ = false;
  std::optional<Ending> ending_;  ///< told when it has been drained
};

}  // namespace

std::shared_ptr<Link> web_link(std::shared_ptr<Link> below, std::string answer,
                               const Limits& limits) {
  return std::make_shared<WebLink>(std::move(below), std::move(answer), limits);
}

}  // namespace aucast::link
