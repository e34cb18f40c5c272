#include "common/link/host.h"

#include "common/text.h"

namespace aucast::link {

std::string host_and_port(std::string_view host, std::uint16_t port) {
  const bool bare_v6 = host.find(':') != std::string_view::npos && !host.starts_with('[');
  const std::string text = escaped(host);
  return (bare_v6 ? "[" + text + "]" : text) + ":" + std::to_string(port);
}

std::string time_text(Milliseconds time) {
  const auto ms = time.count();
  return ms % 1000 == 0 ? std::to_string(ms / 1000) + " s" : std::to_string(ms) + " ms";
}

}  // namespace aucast::link
