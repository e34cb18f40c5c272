#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "common/link/link.h"

namespace aucast::link {

/// A link whose bytes go through a Layer (tls::Layer, web::Layer) over the link below: what all
/// such links have in common. During a call from the link below, this object stays alive even if
/// its user drops it.
template <typename Layer>
class LayerLink : public Link,
                  public LinkUser,
                  public std::enable_shared_from_this<LayerLink<Layer>> {
 public:
  ~LayerLink() override { below_->close(); }

  // === Called by the user.

  void hand_over(LinkUser& user) override { user_ = &user; }
  void write(std::string_view bytes) override {
    if (ending_ || finishing_) return;
    layer_.send(bytes);
    flush();
  }
  void finish() override {
    if (ending_ || std::exchange(finishing_, true)) return;
    layer_.end();
    flush();
    below_->finish();
  }
  void close() override {
    user_ = nullptr;
    below_->close();
  }
  void set_reading(bool reading) override { below_->set_reading(reading); }
  [[nodiscard]] Instant now() const override { return below_->now(); }
  [[nodiscard]] Duration round_trip() const override { return below_->round_trip(); }
  [[nodiscard]] bool blocked() const override { return below_->blocked(); }
  [[nodiscard]] std::optional<Instant> stuck_since() const override {
    return below_->stuck_since();
  }
  [[nodiscard]] std::size_t unsent_bytes() const override { return below_->unsent_bytes(); }
  [[nodiscard]] std::uint64_t wire_bytes() const override { return below_->wire_bytes(); }

  // === Called by the link below.

  void on_closed(const Ending& ending) override {
    const auto alive = this->shared_from_this();
    LinkUser* const user = std::exchange(user_, nullptr);
    user->on_closed(ending_.value_or(ending));
  }

 protected:
  LayerLink(std::shared_ptr<Link> below, Layer layer)
      : below_(std::move(below)), layer_(std::move(layer)) {}

  /// Whether the user is still told of bytes and events.
  [[nodiscard]] bool listening() const { return user_ != nullptr && !finishing_ && !ending_; }

  void flush() {
    if (const std::string wire = layer_.take_output(); !wire.empty()) below_->write(wire);
  }

  std::shared_ptr<Link> below_;
  Layer layer_;
  LinkUser* user_ = nullptr;
  bool finishing_ = false;
  std::optional<Ending> ending_;  ///< why this link ends; reported when the link below has closed
};

}  // namespace aucast::link
