#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "client/web/timer.h"
#include "common/link/link.h"

namespace aucast::web {

/// A link over a WebSocket of the browser, to the page's only server. The browser cannot be kept
/// from reading a WebSocket: what comes while reading is off is kept, and so is the socket's end.
/// If more than kHeldMax bytes are kept, the link ends. Thread: the page's.
class SocketLink final : public link::Link, public std::enable_shared_from_this<SocketLink> {
 public:
  static constexpr std::size_t kHeldMax = std::size_t{1} << 20U;

  [[nodiscard]] static std::shared_ptr<SocketLink> create();
  ~SocketLink() override;

  void start(link::LinkUser& user) override;
  void hand_over(link::LinkUser& user) override { user_ = &user; }
  void write(std::string_view bytes) override;
  void finish() override;
  void close() override;
  void set_reading(bool reading) override;
  void wake_at(std::optional<Instant> when) override { timer_.set(when); }
  [[nodiscard]] Instant now() const override { return web::now(); }
  [[nodiscard]] Duration round_trip() const override { return {}; }
  [[nodiscard]] bool blocked() const override { return false; }
  [[nodiscard]] std::optional<Instant> stuck_since() const override { return std::nullopt; }
  [[nodiscard]] std::size_t unsent_bytes() const override { return 0; }
  [[nodiscard]] std::uint64_t wire_bytes() const override { return wire_bytes_; }

  // Called by the browser, for the link with that number; ignored if there is none any more.
  static void opened(std::uint32_t socket);
  static void received(std::uint32_t socket, std::string_view bytes);
  static void closed(std::uint32_t socket);

 private:
  SocketLink();
  void hand_out();
  void end(const link::Ending& ending);

  const std::uint32_t id_;
  link::LinkUser* user_ = nullptr;
  Timer timer_;
  Timer later_;  ///< hands out what was kept, because that must not happen within a call that the
                 ///< LinkUser makes
  std::string held_;
  bool open_ = false;
  bool reading_ = true;
  bool finishing_ = false;
  bool gone_ = false;        ///< the browser has closed the socket, and says no more of it
  bool peer_ended_ = false;  ///< the user is still to be told so
  std::uint64_t wire_bytes_ = 0;
};

}  // namespace aucast::web
