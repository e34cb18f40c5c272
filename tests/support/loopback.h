#pragma once

#include <netinet/in.h>

#include <cstdint>
#include <string>

namespace aucast::test {

[[nodiscard]] sockaddr_in loopback(std::uint16_t port);

/// The port of HOST:PORT.
[[nodiscard]] std::uint16_t port_of(const std::string& address);

/// A socket that has a free port of this host; who asks for it closes it.
struct LoopbackSocket {
  int descriptor = -1;
  std::uint16_t port = 0;
  [[nodiscard]] std::string address() const { return "127.0.0.1:" + std::to_string(port); }
};
/// Nobody else takes the port, and nobody is heard there.
[[nodiscard]] LoopbackSocket bind_to_loopback();
[[nodiscard]] LoopbackSocket listen_on_loopback(int backlog = 8);

}  // namespace aucast::test
