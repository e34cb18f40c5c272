#pragma once

#include <optional>

namespace aucast {

/// The earlier of two times. nullopt stands for a time that never comes.
template <typename Time>
[[nodiscard]] std::optional<Time> earlier(const std::optional<Time>& one,
                                          const std::optional<Time>& other) {
  return !one || (other && *other < *one) ? other : one;
}

}  // namespace aucast
