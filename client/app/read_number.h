#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "common/number_of.h"

namespace aucast::app {

/// "1 to 100", for a message.
[[nodiscard]] inline std::string text_of_range(std::size_t low, std::size_t high) {
  return std::to_string(low) + " to " + std::to_string(high);
}

/// Reads a number into `out`. Returns false, and leaves `out`, if the text is none from `low` to
/// `high`.
template <typename Number>
[[nodiscard]] bool read_whole(std::string_view text, Number low, Number high, Number& out) {
  const auto value = number_of<Number>(text);
  if (!value || *value < low || *value > high) return false;
  out = *value;
  return true;
}

}  // namespace aucast::app
