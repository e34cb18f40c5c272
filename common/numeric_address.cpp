#include "common/numeric_address.h"

#include <arpa/inet.h>

namespace aucast {

std::string numeric_address(std::string_view text) {
  const std::string word(text);
  std::string bytes(sizeof(in_addr), '\0');
  if (::inet_pton(AF_INET, word.c_str(), bytes.data()) == 1) return bytes;
  bytes.resize(sizeof(in6_addr));
  return ::inet_pton(AF_INET6, word.c_str(), bytes.data()) == 1 ? bytes : std::string();
}

}  // namespace aucast
