#include "common/link/tls_link.h"

#include <optional>
#include <utility>

#include "common/link/host.h"

namespace aucast::link {
namespace {

using tls::Channel;
using Why = Ending::Why;

Why why_of(Channel::Failure failure) {
  switch (failure) {
    case Channel::Failure::NotTls:
      return Why::NotTls;
    case Channel::Failure::Untrusted:
      return Why::Untrusted;
    case Channel::Failure::None:
    case Channel::Failure::Broken:
      break;
  }
  return Why::TlsFailed;
}

/// Whatever is told from below keeps this alive until it is through, for the user may let go.
class TlsLink final : public Link, public LinkUser, public std::enable_shared_from_this<TlsLink> {
 public:
  TlsLink(std::shared_ptr<Link> below, Channel channel, const Limits& limits,
          std::string plain_answer)
      : below_(std::move(below)),
        channel_(std::move(channel)),
        handshake_time_(limits.tls_handshake),
        plain_answer_(std::move(plain_answer)) {}
  ~TlsLink() override { below_->close(); }

  // === What the user asks for.

  void start(LinkUser& user) override {
    user_ = &user;
    below_->start(*this);
  }
  void hand_over(LinkUser& user) override { user_ = &user; }
  void write(std::string_view bytes) override {
    if (failure_ || finishing_) return;
    channel_.send(bytes);
    flush();
  }
  void finish() override {
    if (failure_ || std::exchange(finishing_, true)) return;
    channel_.end();
    flush();
    below_->finish();
  }
  void close() override {
    user_ = nullptr;
    below_->close();
  }
  void set_reading(bool reading) override { below_->set_reading(reading); }
  void wake_at(std::optional<Instant> when) override {
    wake_at_ = when;
    if (open_) below_->wake_at(when);
  }
  [[nodiscard]] Instant now() const override { return below_->now(); }
  [[nodiscard]] Duration round_trip() const override { return below_->round_trip(); }
  [[nodiscard]] bool blocked() const override { return below_->blocked(); }
  [[nodiscard]] std::optional<Instant> stuck_since() const override {
    return below_->stuck_since();
  }
  [[nodiscard]] std::size_t unsent_bytes() const override { return below_->unsent_bytes(); }
  [[nodiscard]] std::uint64_t wire_bytes() const override { return below_->wire_bytes(); }

  // === What the link below tells.

  void on_open() override {
    below_->wake_at(now() + handshake_time_);
    flush();
  }

  void on_bytes(std::string_view wire) override {
    const auto alive = shared_from_this();
    std::string plain;
    const bool good = channel_.received(wire, plain);
    // Not sent yet: our last part of the handshake and the user's first words go out in one piece.
    if (!open_ && channel_.ready()) open();
    if (!plain.empty() && listening()) user_->on_bytes(plain);
    flush();
    if (!listening()) return;
    if (!good) {
      fail(why_of(channel_.failure()), channel_.reason(),
           channel_.failure() == Channel::Failure::NotTls);
    } else if (channel_.ended()) {
      tell_peer_end();
    }
  }

  void on_peer_end() override {
    const auto alive = shared_from_this();
    if (open_) {
      tell_peer_end();
    } else {
      fail(Why::TlsFailed, "the connection ended within the TLS handshake", false);
    }
  }

  void on_room() override {
    const auto alive = shared_from_this();
    if (open_) user_->on_room();
  }

  void on_time() override {
    const auto alive = shared_from_this();
    if (open_) {
      wake_at_.reset();
      user_->on_time();
    } else {
      fail(Why::TlsFailed, "no TLS handshake within " + time_text(handshake_time_), true);
    }
  }

  void on_closed(const Ending& ending) override {
    const auto alive = shared_from_this();
    LinkUser* const user = std::exchange(user_, nullptr);
    user->on_closed(failure_.value_or(ending));
  }

 private:
  /// The user wants to know.
  [[nodiscard]] bool listening() const { return user_ != nullptr && !finishing_ && !failure_; }

  void open() {
    open_ = true;
    below_->wake_at(wake_at_);
    user_->on_open();
  }

  void flush() {
    if (const std::string wire = channel_.take_output(); !wire.empty()) below_->write(wire);
  }

  void tell_peer_end() {
    if (!std::exchange(peer_ended_, true)) user_->on_peer_end();
  }

  void fail(Why why, std::string reason, bool answer) {
    failure_ = Ending{why, std::move(reason)};
    if (answer) below_->write(plain_answer_);
    below_->finish();
    user_->on_failure(*failure_);
  }

  std::shared_ptr<Link> below_;
  Channel channel_;
  Milliseconds handshake_time_;
  std::string plain_answer_;
  LinkUser* user_ = nullptr;
  bool open_ = false;
  bool finishing_ = false;
  bool peer_ended_ = false;
  std::optional<Instant> wake_at_;  ///< the user's
  std::optional<Ending> failure_;   ///< told when it has been drained
};

}  // namespace

std::shared_ptr<Link> tls_link(std::shared_ptr<Link> below, Channel channel, const Limits& limits,
                               std::string plain_answer) {
  return std::make_shared<TlsLink>(std::move(below), std::move(channel), limits,
                                   std::move(plain_answer));
}

}  // namespace aucast::link
