#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

namespace aucast::bench {

/// Peers that connect, send rubbish and leave, as fast as they can, on a thread of their own. The
/// rubbish is random bytes, a hello or HTTP head that never ends, a flood of codes, a request or
/// nothing at all. Peers leave in order or by a reset.
class Flood {
 public:
  /// `at_a_time`: how many are connected at once; another one replaces each that leaves.
  Flood(std::uint16_t port, int at_a_time);
  ~Flood();
  Flood(const Flood&) = delete;
  Flood& operator=(const Flood&) = delete;

  [[nodiscard]] std::int64_t peers() const { return peers_; }
  [[nodiscard]] std::int64_t bytes() const { return bytes_; }

 private:
  void run(std::uint16_t port, int at_a_time);

  std::atomic<bool> stop_{false};
  std::atomic<std::int64_t> peers_{0};
  std::atomic<std::int64_t> bytes_{0};
  std::thread thread_;
};

}  // namespace aucast::bench
