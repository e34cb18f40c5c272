#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>
#include <thread>

namespace aucast::test {

/// What is bad about a link, in both directions alike.
struct LinkQuality {
  std::chrono::milliseconds delay{0};
  std::chrono::milliseconds jitter{0};  ///< up to so much more or less than the delay
  int kilobits = 0;                     ///< a second; 0: as fast as it goes
};

/// Stands between clients and a server on this host and makes the link a bad one. It needs no
/// privileges and loses nothing, since TCP turns losses into delay and silence. For losses of
/// packets see linkemu.
/// Thread: one of its own; one other thread may call the members.
class FaultProxy {
 public:
  /// `server`: HOST:PORT, IPv4.
  FaultProxy(const std::string& server, LinkQuality quality, std::uint64_t seed);
  ~FaultProxy();
  FaultProxy(const FaultProxy&) = delete;
  FaultProxy& operator=(const FaultProxy&) = delete;

  /// Where clients connect to.
  [[nodiscard]] const std::string& address() const { return address_; }
  /// While it is down nothing gets through, but connections stay open.
  void set_down(bool down) { down_ = down; }
  /// Bytes that reached clients so far.
  [[nodiscard]] std::int64_t bytes_to_clients() const { return bytes_to_clients_; }

 private:
  void run(std::uint16_t server_port, LinkQuality quality, std::uint64_t seed);

  int listener_ = -1;
  std::string address_;
  std::atomic<bool> stop_{false};
  std::atomic<bool> down_{false};
  std::atomic<std::int64_t> bytes_to_clients_{0};
  std::thread thread_;
};

}  // namespace aucast::test
