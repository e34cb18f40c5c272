#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/result.h"
#include "protocol/limits.h"

namespace aucast::protocol {

/// The address of a server.
struct Endpoint {
  std::string host;
  std::uint16_t port = kDefaultPort;
  friend bool operator==(const Endpoint&, const Endpoint&) = default;
};

/// Reads HOST, HOST:PORT, [V6]:PORT or [V6]. Fails with a Usage error for anything else.
[[nodiscard]] Result<Endpoint> parse_endpoint(std::string_view text);

/// The address of a stream, which may be at several servers.
struct StreamAddress {
  std::vector<Endpoint> hosts;  ///< at least one, in the order in which they are to be tried
  bool tls = false;
  std::string stream;  ///< empty: the server's first
  friend bool operator==(const StreamAddress&, const StreamAddress&) = default;
};

/// Whether the text begins like a stream's address; the rest is not checked.
[[nodiscard]] bool is_stream_address(std::string_view text);

/// Reads aucast://HOST[:PORT][,HOST[:PORT]...][/STREAM], or aucasts:// for TLS. Fails with a Usage
/// error for anything else.
[[nodiscard]] Result<StreamAddress> parse_stream_address(std::string_view text);

/// Whether the text begins like the address of a stream at NATS; the rest is not checked.
[[nodiscard]] bool is_engine_address(std::string_view text);

/// Reads nats://HOST[:PORT][,HOST[:PORT]...]/STREAM, or natss:// for TLS: the address of a stream
/// at servers of NATS (ENGINE.md). The stream must be named. Fails with a Usage error for anything
/// else.
[[nodiscard]] Result<StreamAddress> parse_engine_address(std::string_view text);

}  // namespace aucast::protocol
