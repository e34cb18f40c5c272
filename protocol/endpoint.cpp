#include "protocol/endpoint.h"

#include <arpa/inet.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "common/number_of.h"
#include "common/text.h"
#include "protocol/codec.h"

namespace aucast::protocol {
namespace {

/// Only what is wrong: the caller says with what, and the remedy.
Error bad(std::string what) {
  return {ErrorKind::Usage, std::move(what)};
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
  const auto port = number_of<std::uint16_t>(text);
  return port == 0 ? std::nullopt : port;
}

Result<Endpoint> read_endpoint(std::string_view text) {
  Endpoint endpoint;
  std::string_view host = text;
  std::optional<std::string_view> port;

  if (text.starts_with('[')) {
    const std::size_t close = text.find(']');
    if (close == std::string_view::npos) return bad("the bracket is not closed");
    host = text.substr(1, close - 1);
    if (!is_v6(host)) return bad("an IPv6 address must stand in the brackets");
    const std::string_view rest = text.substr(close + 1);
    if (!rest.empty() && rest.front() != ':') {
      return bad("only :PORT may follow the bracket");
    }
    if (!rest.empty()) port = rest.substr(1);
  } else if (const auto colons = std::count(text.begin(), text.end(), ':'); colons == 1) {
    const std::size_t colon = text.find(':');
    host = text.substr(0, colon);
    port = text.substr(colon + 1);
  } else if (colons > 1 && !is_v6(text)) {
    return bad("an IPv6 address with a port needs brackets");
  }

  if (host.empty()) return bad("there is no host");
  if (!std::all_of(host.begin(), host.end(), is_host_byte)) {
    return bad("a host has no blanks, brackets or special bytes");
  }
  if (port) {
    const auto number = parse_port(*port);
    if (!number) return bad("the port must be a number from 1 to 65535");
    endpoint.port = *number;
  }
  endpoint.host = host;
  return endpoint;
}

constexpr std::string_view kPlain = "aucast://";
constexpr std::string_view kSecure = "aucasts://";

Error bad_address(std::string_view text, const std::string& what) {
  return {ErrorKind::Usage, "'" + escaped(text) + "' is no address of a stream: " + what +
                                "; use aucast://HOST[:PORT][,HOST...][/STREAM], or aucasts:// "
                                "for TLS"};
}

}  // namespace

Result<Endpoint> parse_endpoint(std::string_view text) {
  auto endpoint = read_endpoint(text);
  if (endpoint) return endpoint;
  return Error{ErrorKind::Usage, "'" + escaped(text) +
                                     "' is no address of a server: " + endpoint.error().message +
                                     "; use HOST, HOST:PORT or [IPV6]:PORT"};
}

bool is_stream_address(std::string_view text) {
  return text.starts_with(kPlain) || text.starts_with(kSecure);
}

Result<StreamAddress> parse_stream_address(std::string_view text) {
  StreamAddress address;
  address.tls = text.starts_with(kSecure);
  if (!is_stream_address(text)) return bad_address(text, "it begins with neither");
  std::string_view hosts = text.substr(address.tls ? kSecure.size() : kPlain.size());
  if (const std::size_t slash = hosts.find('/'); slash != std::string_view::npos) {
    address.stream = hosts.substr(slash + 1);
    hosts = hosts.substr(0, slash);
    if (!address.stream.empty() && !is_stream_name(address.stream)) {
      return bad_address(text, "a stream's name has 1 to 64 letters, digits, '.', '_' or '-'");
    }
  }
  for (const std::string_view host : split(hosts, ',')) {
    auto endpoint = read_endpoint(host);
    if (!endpoint) return bad_address(text, endpoint.error().message);
    address.hosts.push_back(*std::move(endpoint));
  }
  return address;
}

}  // namespace aucast::protocol
