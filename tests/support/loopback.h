#pragma once

#include <netinet/in.h>

#include <cstdint>
#include <string>

namespace aucast::test {

[[nodiscard]] sockaddr_in loopback(std::uint16_t port);

/// The port of HOST:PORT.
[[nodiscard]] std::uint16_t port_of(const std::string& address);

/// A socket on a free port of this host; the caller closes it.
struct LoopbackSocket {
  int descriptor = -1;
  std::uint16_t port = 0;
  [[nodiscard]] std::string address() const { return "127.0.0.1:" + std::to_string(port); }
};
/// Keeps a port from others without listening: connections to it are refused.
[[nodiscard]] LoopbackSocket bind_to_loopback();
[[nodiscard]] LoopbackSocket listen_on_loopback(int backlog = 8);

}  // namespace aucast::test
