#pragma once

#include <cstddef>
#include <string>

namespace aucast {

/// How many digits the IDs have by which relays see their own streams come back, and servers tell
/// publishers apart.
inline constexpr std::size_t kIdDigits = 12;

/// So many hexadecimal digits of chance from the system.
[[nodiscard]] std::string random_digits(std::size_t count);

}  // namespace aucast
