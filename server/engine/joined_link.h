#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "common/link/link.h"

namespace aucast::server {

/// Makes a stream that was joined at an engine look like a connection. The user of the connection
/// gets the hello, the whole face and the packets after it, as from any server. What the user sends
/// is dropped, since an engine takes no answers.
/// Thread: the loop's.
class JoinedLink final : public link::Link, public std::enable_shared_from_this<JoinedLink> {
 public:
  /// Passes these packets to the user, each in a call of its own, until the user closes the link.
  void deliver(std::string_view packets);
  /// Reports a loss to the user, unless the user has closed the link.
  void lose(const std::string& reason);

  void start(link::LinkUser& user) override;
  void hand_over(link::LinkUser& user) override { user_ = &user; }
  void write(std::string_view /*bytes*/) override {}
  void finish() override { user_ = nullptr; }
  void close() override { user_ = nullptr; }
  void set_reading(bool /*reading*/) override {}
  /// Not needed: a session has no deadline once it has the hello, which comes at once.
  void wake_at(std::optional<Instant> /*when*/) override {}

  [[nodiscard]] Instant now() const override;
  [[nodiscard]] Duration round_trip() const override { return {}; }
  [[nodiscard]] bool blocked() const override { return false; }
  [[nodiscard]] std::optional<Instant> stuck_since() const override { return std::nullopt; }
  [[nodiscard]] std::size_t unsent_bytes() const override { return 0; }
  [[nodiscard]] std::uint64_t wire_bytes() const override { return 0; }

 private:
  link::LinkUser* user_ = nullptr;
};

}  // namespace aucast::server
