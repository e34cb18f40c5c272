#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "common/time.h"

namespace aucast::link {

/// localhost or a name below it, in any case and with or without the final dot. RFC 6761: such a
/// name is the loopback, whatever a resolver would say.
[[nodiscard]] bool is_localhost(std::string_view host);

/// Names this very computer: localhost or an address of the loopback.
[[nodiscard]] bool is_own_host(std::string_view host);

/// HOST:PORT for messages: bytes from outside escaped, an IPv6 address in brackets.
[[nodiscard]] std::string host_and_port(std::string_view host, std::uint16_t port);

/// "10 s", "250 ms".
[[nodiscard]] std::string time_text(Milliseconds time);

}  // namespace aucast::link
