#pragma once

#include <string_view>

namespace aucast {

/// Whether the host is localhost or a name below it, in any case, with or without the final dot. By
/// RFC 6761 such a name is the loopback, whatever a resolver would answer.
[[nodiscard]] bool is_localhost(std::string_view host);

/// Whether the host is this computer: is_localhost(), or an address of the loopback.
[[nodiscard]] bool is_own_computer(std::string_view host);

}  // namespace aucast
