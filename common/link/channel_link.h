#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "common/link/link.h"

namespace aucast::link {

/// A link whose bytes go through a Channel (tls::Channel, web::Channel) over the link below: what
/// all such links have in common. Whatever is told from below keeps this alive until it is through,
/// for the user may let go.
template <typename Channel>
class ChannelLink : public Link,
                    public LinkUser,
                    public std::enable_shared_from_this<ChannelLink<Channel>> {
 public:
  ~ChannelLink() override { below_->close(); }

  // === What the user asks for.

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
  [[nodiscard]] Instant now() const override { return below_->now(); }
  [[nodiscard]] Duration round_trip() const override { return below_->round_trip(); }
  [[nodiscard]] bool blocked() const override { return below_->blocked(); }
  [[nodiscard]] std::optional<Instant> stuck_since() const override {
    return below_->stuck_since();
  }
  [[nodiscard]] std::size_t unsent_bytes() const override { return below_->unsent_bytes(); }
  [[nodiscard]] std::uint64_t wire_bytes() const override { return below_->wire_bytes(); }

  // === What the link below tells.

  void on_closed(const Ending& ending) override {
    const auto alive = this->shared_from_this();
    LinkUser* const user = std::exchange(user_, nullptr);
    user->on_closed(ending_.value_or(ending));
  }

 protected:
  ChannelLink(std::shared_ptr<Link> below, Channel channel)
      : below_(std::move(below)), channel_(std::move(channel)) {}

  /// The user wants to know.
  [[nodiscard]] bool listening() const { return user_ != nullptr && !finishing_ && !ending_; }

  void flush() {
    if (const std::string wire = channel_.take_output(); !wire.empty()) below_->write(wire);
  }

  std::shared_ptr<Link> below_;
  Channel channel_;
  LinkUser* user_ = nullptr;
  bool finishing_ = false;
  std::optional<Ending> ending_;  ///< told when what waits has been drained
};

}  // namespace aucast::link
