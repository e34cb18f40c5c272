#pragma once

#include <string>
#include <string_view>

namespace aucast {

/// The bytes of an IP address in numbers: four of IPv4, sixteen of IPv6; empty if the text is none,
/// such as a name, or has a zone behind it.
[[nodiscard]] std::string numeric_address(std::string_view text);

}  // namespace aucast
