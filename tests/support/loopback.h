#pragma once

#include <netinet/in.h>

#include <cstdint>
#include <string>

namespace aucast::test {

[[nodiscard]] sockaddr_in loopback(std::uint16_t port);

/// The port of HOST:PORT.
[[nodiscard]] std::uint16_t port_of(const std::string& address);

/// A socket that listens on a free port of this host; who asks for it closes it.
struct LoopbackListener {
  int descriptor = -1;
  std::string address;  ///< 127.0.0.1:PORT
};
[[nodiscard]] LoopbackListener listen_on_loopback();

}  // namespace aucast::test
