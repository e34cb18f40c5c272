#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace aucast::bench {

using Clock = std::chrono::steady_clock;

inline constexpr const char* kOurs = "au-transmitter";

/// What is measured: `clients` subscribers get `burst` messages at once, `rate` times a second.
struct Plan {
  int clients = 1000;
  double rate = 30;
  int burst = 1;
  int seconds = 5;
  int rounds = 5;
  bool from_said = false;  ///< other servers' latency counts from when a message was said, not due
  bool web = false;        ///< the crowd comes by WebSocket; au-transmitter only
  int flood = 0;           ///< how many peers send rubbish at a time (Flood); au-transmitter only
  int edges = 0;  ///< servers behind the first; the crowd is spread over them. 0: the first alone
  bool one_port = false;   ///< all edges share one port (--reuse-port); au-transmitter only
  std::uint16_t port = 0;  ///< of the server; 0: any free one
  std::optional<std::size_t> server_processor{};  ///< the server runs on this alone; nullopt: any
  std::optional<std::size_t> crowd_processor{};   ///< the same for this program
  std::vector<int> trees{};                       ///< numbers of edges that are measured too
  std::vector<std::string> against{"redis", "mosquitto"};

  [[nodiscard]] int period_ms() const { return static_cast<int>(1000 / rate); }
  /// When message `number` is published, counted from the first.
  [[nodiscard]] Clock::duration place(std::int64_t number) const {
    return std::chrono::milliseconds(number / burst * period_ms());
  }
};

}  // namespace aucast::bench
