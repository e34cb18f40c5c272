#pragma once

#include <cstddef>
#include <string>

namespace aucast {

/// So many hexadecimal digits of chance from the system.
[[nodiscard]] std::string random_digits(std::size_t count);

}  // namespace aucast
