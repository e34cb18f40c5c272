#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

namespace aucast::test {

/// Stands between a client and a server on this host and passes the bytes on in other portions than
/// they came in, with small delays; the seed decides both. One connection at a time.
class Relay {
 public:
  /// `server`: HOST:PORT, IPv4.
  Relay(const std::string& server, std::uint64_t seed);
  ~Relay();
  Relay(const Relay&) = delete;
  Relay& operator=(const Relay&) = delete;

  /// Where the client connects to.
  [[nodiscard]] const std::string& address() const { return address_; }

 private:
  void run(std::uint16_t server_port, std::uint64_t seed);

  int listener_ = -1;
  std::string address_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace aucast::test
