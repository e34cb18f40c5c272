#include "common/link/host.h"

#include <system_error>

#include <asio/ip/address.hpp>

#include "common/text.h"

namespace aucast::link {

bool is_localhost(std::string_view host) {
  if (host.ends_with('.')) host.remove_suffix(1);
  const std::string name = lowered(host);
  return name == "localhost" || name.ends_with(".localhost");
}

bool is_own_host(std::string_view host) {
  if (is_localhost(host)) return true;
  std::error_code no_address;
  const auto address = asio::ip::make_address(std::string(host), no_address);
  return !no_address && address.is_loopback();
}

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
