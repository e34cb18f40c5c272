#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

namespace aucast::bench {

/// Peers that come, say rubbish and go, as fast as they can, on a thread of their own: random
/// bytes, hellos and HTTP heads that never end, floods of codes, requests, nothing at all; leaving
/// in order or by a reset.
class Flood {
 public:
  /// `at_a_time`: connections that are open; each is replaced when it has said its piece.
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
