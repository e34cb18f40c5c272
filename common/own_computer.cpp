#include "common/own_computer.h"

#include <string>

#include "common/numeric_address.h"
#include "common/text.h"

namespace aucast {

bool is_localhost(std::string_view host) {
  if (host.ends_with('.')) host.remove_suffix(1);
  const std::string name = lowered(host);
  return name == "localhost" || name.ends_with(".localhost");
}

bool is_own_computer(std::string_view host) {
  if (is_localhost(host)) return true;
  const std::string address = numeric_address(host);
  const bool v4 = address.size() == 4;
  return v4 ? address.front() == 127 : !address.empty() && address == numeric_address("::1");
}

}  // namespace aucast
