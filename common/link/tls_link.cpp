#include "common/link/tls_link.h"

#include <optional>
#include <utility>

#include "common/link/host.h"
#include "common/link/layer_link.h"

namespace aucast::link {
namespace {

using tls::Layer;
using Why = Ending::Why;

Why why_of(Layer::Why why) {
  switch (why) {
    case Layer::Why::NotTls:
      return Why::NotTls;
    case Layer::Why::Untrusted:
      return Why::Untrusted;
    case Layer::Why::None:
    case Layer::Why::Broken:
      break;
  }
  return Why::TlsFailed;
}

class TlsLink final : public LayerLink<Layer> {
 public:
  TlsLink(std::shared_ptr<Link> below, Layer layer, const Limits& limits, std::string plain_answer)
      : LayerLink(std::move(below), std::move(layer)),
        handshake_time_(limits.tls_handshake),
        plain_answer_(std::move(plain_answer)) {}

  void start(LinkUser& user) override {
    user_ = &user;
    below_->start(*this);
  }
  void wake_at(std::optional<Instant> when) override {
    wake_at_ = when;
    if (open_) below_->wake_at(when);
  }

  // === What the link below tells.

  void on_open() override {
    below_->wake_at(now() + handshake_time_);
    flush();
  }

  void on_bytes(std::string_view wire) override {
    const auto alive = shared_from_this();
    std::string plain;
    const bool good = layer_.received(wire, plain);
    // Not sent yet: our last part of the handshake and the user's first words go out in one piece.
    if (!open_ && layer_.ready()) open();
    if (!plain.empty() && listening()) user_->on_bytes(plain);
    flush();
    if (!listening()) return;
    if (!good) {
      fail(why_of(layer_.why()), layer_.reason(), layer_.why() == Layer::Why::NotTls);
    } else if (layer_.ended()) {
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

 private:
  void open() {
    open_ = true;
    below_->wake_at(wake_at_);
    user_->on_open();
  }

  void tell_peer_end() {
    if (!std::exchange(peer_ended_, true)) user_->on_peer_end();
  }

  void fail(Why why, std::string reason, bool answer) {
    ending_ = Ending{why, std::move(reason)};
    if (answer) below_->write(plain_answer_);
    below_->finish();
    user_->on_failure(*ending_);
  }

  Milliseconds handshake_time_;
  std::string plain_answer_;
  bool open_ = false;
  bool peer_ended_ = false;
  std::optional<Instant> wake_at_;  ///< the user's
};

}  // namespace

std::shared_ptr<Link> tls_link(std::shared_ptr<Link> below, Layer layer, const Limits& limits,
                               std::string plain_answer) {
  return std::make_shared<TlsLink>(std::move(below), std::move(layer), limits,
                                   std::move(plain_answer));
}

}  // namespace aucast::link
