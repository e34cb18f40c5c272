#include "common/own_computer.h"

#include <arpa/inet.h>

#include <array>
#include <string>

#include "common/text.h"

namespace aucast {

bool is_localhost(std::string_view host) {
  if (host.ends_with('.')) host.remove_suffix(1);
  const std::string name = lowered(host);
  return name == "localhost" || name.ends_with(".localhost");
}

bool is_own_computer(std::string_view host) {
  if (is_localhost(host)) return true;
  const std::string text(host);
  std::array<unsigned char, sizeof(in6_addr)> bytes{};
  if (::inet_pton(AF_INET, text.c_str(), bytes.data()) == 1) return bytes[0] == 127;
  constexpr std::array<unsigned char, sizeof(in6_addr)> kLoopback{0, 0, 0, 0, 0, 0, 0, 0,
                                                                  0, 0, 0, 0, 0, 0, 0, 1};
  return ::inet_pton(AF_INET6, text.c_str(), bytes.data()) == 1 && bytes == kLoopback;
}

}  // namespace aucast
