#pragma once

#include <optional>

namespace aucast {

/// The earlier of two moments that may never come; nothing when neither does.
template <typename Moment>
[[nodiscard]] std::optional<Moment> earlier(const std::optional<Moment>& one,
                                            const std::optional<Moment>& other) {
  return !one || (other && *other < *one) ? other : one;
}

}  // namespace aucast
