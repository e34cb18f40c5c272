#include <arpa/inet.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

#include "client/net/remote_source.h"
#include "common/text.h"

namespace aucast::net {
namespace {

Error bad_endpoint(std::string_view text, std::string_view what) {
  return {ErrorKind::Usage, "'" + escaped(text) + "' is no address of a server: " +
                                std::string(what) + "; use HOST, HOST:PORT or [IPV6]:PORT"};
}

bool is_v6(std::string_view text) {
  // A zone such as %eth0 names an interface; inet_pton does not know it.
  const std::string address(text.substr(0, text.find('%')));
  std::array<unsigned char, 16> bytes{};
  return ::inet_pton(AF_INET6, address.c_str(), bytes.data()) == 1;
}

bool is_host_byte(char byte) {
  return byte > ' ' && byte < '\x7f' && byte != '[' && byte != ']';
}

std::optional<std::uint16_t> parse_port(std::string_view text) {
  std::uint16_t port = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, failure] = std::from_chars(text.data(), end, port);
  if (failure != std::errc{} || stopped != end || port == 0) return std::nullopt;
  return port;
}

}  // namespace

Result<Endpoint> parse_endpoint(std::string_view text) {
  Endpoint endpoint;
  std::string_view host = text;
  std::optional<std::string_view> port;

  if (text.starts_with('[')) {
    const std::size_t close = text.find(']');
    if (close == std::string_view::npos) return bad_endpoint(text, "the bracket is not closed");
    host = text.substr(1, close - 1);
    if (!is_v6(host)) return bad_endpoint(text, "an IPv6 address must stand in the brackets");
    const std::string_view rest = text.substr(close + 1);
    if (!rest.empty() && rest.front() != ':') {
      return bad_endpoint(text, "only :PORT may follow the bracket");
    }
    if (!rest.empty()) port = rest.substr(1);
  } else if (const auto colons = std::count(text.begin(), text.end(), ':'); colons == 1) {
    const std::size_t colon = text.find(':');
    host = text.substr(0, colon);
    port = text.substr(colon + 1);
  } else if (colons > 1 && !is_v6(text)) {
    return bad_endpoint(text, "an IPv6 address with a port needs brackets");
  }

  if (host.empty()) return bad_endpoint(text, "there is no host");
  if (!std::all_of(host.begin(), host.end(), is_host_byte)) {
    return bad_endpoint(text, "a host has no blanks, brackets or special bytes");
  }
  if (port) {
    const auto number = parse_port(*port);
    if (!number) return bad_endpoint(text, "the port must be a number from 1 to 65535");
    endpoint.port = *number;
  }
  endpoint.host = host;
  return endpoint;
}

}  // namespace aucast::net
