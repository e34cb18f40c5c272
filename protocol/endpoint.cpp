#include "protocol/endpoint.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "common/number_of.h"
#include "common/numeric_address.h"
#include "common/text.h"
#include "protocol/codec.h"
#include "protocol/engine_message.h"

namespace aucast::protocol {
namespace {

/// Returns only what is wrong; the caller adds the text concerned and the remedy.
Error bad_address(std::string what) {
  return {ErrorKind::Usage, std::move(what)};
}

bool is_v6(std::string_view text) {
  // A zone such as %eth0 names an interface of this computer; it is no part of the address.
  return numeric_address(text.substr(0, text.find('%'))).size() == 16;
}

bool is_host_byte(char byte) {
  return byte > ' ' && byte < '\x7f' &&
         std::string_view("[]\"'\\").find(byte) == std::string_view::npos;
}

std::optional<std::uint16_t> parse_port(std::string_view text) {
  const auto port = number_of<std::uint16_t>(text);
  return port == 0 ? std::nullopt : port;
}

Result<Endpoint> read_endpoint(std::string_view text, std::uint16_t default_port = kDefaultPort) {
  Endpoint endpoint;
  endpoint.port = default_port;
  std::string_view host = text;
  std::optional<std::string_view> port;

  if (text.starts_with('[')) {
    const std::size_t close = text.find(']');
    if (close == std::string_view::npos) return bad_address("the bracket is not closed");
    host = text.substr(1, close - 1);
    if (!is_v6(host)) return bad_address("an IPv6 address must stand in the brackets");
    const std::string_view rest = text.substr(close + 1);
    if (!rest.empty() && rest.front() != ':') {
      return bad_address("only :PORT may follow the bracket");
    }
    if (!rest.empty()) port = rest.substr(1);
  } else if (const auto colons = std::count(text.begin(), text.end(), ':'); colons == 1) {
    const std::size_t colon = text.find(':');
    host = text.substr(0, colon);
    port = text.substr(colon + 1);
  } else if (colons > 1 && !is_v6(text)) {
    return bad_address("an IPv6 address with a port needs brackets");
  }

  if (host.empty()) return bad_address("there is no host");
  if (!std::all_of(host.begin(), host.end(), is_host_byte)) {
    return bad_address("a host has no blanks, brackets, quotes, backslashes or special bytes");
  }
  if (port) {
    const auto number = parse_port(*port);
    if (!number) return bad_address("the port must be a number from 1 to 65535");
    endpoint.port = *number;
  }
  endpoint.host = host;
  return endpoint;
}

/// How addresses of one kind are written.
struct Scheme {
  std::string_view plain;
  std::string_view secure;
  std::uint16_t port;
  const char* form;  ///< the right form, for messages
};

constexpr Scheme kServers{"aucast://", "aucasts://", kDefaultPort,
                          "aucast://HOST[:PORT][,HOST...][/STREAM], or aucasts:// for TLS"};
constexpr Scheme kEngine{"nats://", "natss://", kEnginePort,
                         "nats://HOST[:PORT][,HOST...]/STREAM, or natss:// for TLS"};

bool begins_as(const Scheme& scheme, std::string_view text) {
  return text.starts_with(scheme.plain) || text.starts_with(scheme.secure);
}

Error bad_address(const Scheme& scheme, std::string_view text, const std::string& what) {
  return {ErrorKind::Usage,
          "'" + escaped(text) + "' is no address of a stream: " + what + "; use " + scheme.form};
}

Result<StreamAddress> read_address(const Scheme& scheme, std::string_view text) {
  StreamAddress address;
  address.tls = text.starts_with(scheme.secure);
  if (!begins_as(scheme, text)) return bad_address(scheme, text, "it begins with neither");
  std::string_view hosts = text.substr((address.tls ? scheme.secure : scheme.plain).size());
  if (const std::size_t slash = hosts.find('/'); slash != std::string_view::npos) {
    address.stream = hosts.substr(slash + 1);
    hosts = hosts.substr(0, slash);
    if (!address.stream.empty() && !is_stream_name(address.stream)) {
      return bad_address(scheme, text, std::string("a stream's name has ") + kStreamNameRule);
    }
  }
  for (const std::string_view host : split(hosts, ',')) {
    auto endpoint = read_endpoint(host, scheme.port);
    if (!endpoint) return bad_address(scheme, text, endpoint.error().message);
    address.hosts.push_back(*std::move(endpoint));
  }
  return address;
}

/// In a subject of NATS, dots separate words, none of which may be empty.
bool is_subject_part(std::string_view name) {
  const auto words = split(name, '.');
  return std::none_of(words.begin(), words.end(), [](auto word) { return word.empty(); });
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
  return begins_as(kServers, text);
}

Result<StreamAddress> parse_stream_address(std::string_view text) {
  return read_address(kServers, text);
}

bool is_engine_address(std::string_view text) {
  return begins_as(kEngine, text);
}

Result<StreamAddress> parse_engine_address(std::string_view text) {
  auto address = read_address(kEngine, text);
  if (!address) return address;
  if (address->stream.empty()) return bad_address(kEngine, text, "it names no stream");
  // The client library of NATS would take what is before it for a password.
  if (std::any_of(address->hosts.begin(), address->hosts.end(), [](const Endpoint& server) {
        return server.host.find('@') != std::string::npos;
      })) {
    return bad_address(kEngine, text, "a host has no '@'; secrets are read from files");
  }
  if (!is_subject_part(address->stream)) {
    return bad_address(kEngine, text, "at NATS there is something before and after each '.'");
  }
  return address;
}

}  // namespace aucast::protocol
