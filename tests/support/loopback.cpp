#include "tests/support/loopback.h"

#include <arpa/inet.h>
#include <sys/socket.h>

#include "common/check.h"

namespace aucast::test {

sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(port);
  return address;
}

std::uint16_t port_of(const std::string& address) {
  return static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1)));
}

LoopbackListener listen_on_loopback() {
  LoopbackListener listener;
  listener.descriptor = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address = loopback(0);
  auto* general = reinterpret_cast<sockaddr*>(&address);
  AUCAST_CHECK(::bind(listener.descriptor, general, sizeof address) == 0);
  AUCAST_CHECK(::listen(listener.descriptor, 8) == 0);
  socklen_t size = sizeof address;
  ::getsockname(listener.descriptor, general, &size);
  listener.address = "127.0.0.1:" + std::to_string(ntohs(address.sin_port));
  return listener;
}

}  // namespace aucast::test
