#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "common/time.h"

namespace aucast::link {

/// HOST:PORT for messages: bytes from outside escaped, an IPv6 address in brackets.
[[nodiscard]] std::string host_and_port(std::string_view host, std::uint16_t port);

/// A time for messages: "10 s", "250 ms".
[[nodiscard]] std::string time_text(Milliseconds time);

}  // namespace aucast::link
