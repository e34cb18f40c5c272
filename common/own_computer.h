#pragma once

#include <string_view>

namespace aucast {

/// localhost or a name below it, in any case and with or without the final dot. By RFC 6761 such a
/// name is the loopback, whatever a resolver would say.
[[nodiscard]] bool is_localhost(std::string_view host);

/// Whether it names this computer: localhost or an address of the loopback.
[[nodiscard]] bool is_own_computer(std::string_view host);

}  // namespace aucast
