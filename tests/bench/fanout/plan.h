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

/// What is measured: so many subscribers get `burst` messages at once, `rate` times a second.
struct Plan {
  int clients = 1000;
  double rate = 30;
  int burst = 1;
  int seconds = 5;
  int rounds = 5;
  bool from_said = false;  ///< latency of the others from being said, not from being due
  bool web = false;        ///< by WebSocket; au-transmitter only
  int flood = 0;  ///< connections at a time that say rubbish meanwhile; au-transmitter only
  int edges = 0;  ///< servers behind the first, which the crowd is spread over; 0: the first alone
  bool one_port = false;   ///< the edges have one together (--reuse-port); au-transmitter only
  std::uint16_t port = 0;  ///< of the server; 0: any free one
  std::optional<std::size_t> server_processor{};  ///< that alone; nothing: any
  std::optional<std::size_t> crowd_processor{};   ///< of this program
  std::vector<int> trees{};                       ///< also measured: each a number of edges
  std::vector<std::string> against{"redis", "mosquitto"};

  [[nodiscard]] int period_ms() const { return static_cast<int>(1000 / rate); }
  /// When message `number` is published, counted from the first.
  [[nodiscard]] Clock::duration place(std::int64_t number) const {
    return std::chrono::milliseconds(number / burst * period_ms());
  }
};

}  // namespace aucast::bench
