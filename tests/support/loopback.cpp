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

LoopbackSocket bind_to_loopback() {
  LoopbackSocket bound;
  bound.descriptor = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address = loopback(0);
  auto* general = reinterpret_cast<sockaddr*>(&address);
  socklen_t size = sizeof address;
  AUCAST_CHECK(::bind(bound.descriptor, general, size) == 0);
  AUCAST_CHECK(::getsockname(bound.descriptor, general, &size) == 0);
  bound.port = ntohs(address.sin_port);
  return bound;
}

LoopbackSocket listen_on_loopback(int backlog) {
  const LoopbackSocket listener = bind_to_loopback();
  AUCAST_CHECK(::listen(listener.descriptor, backlog) == 0);
  return listener;
}

}  // namespace aucast::test
