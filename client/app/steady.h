#pragma once

#include <string>

#include "common/time.h"

namespace aucast::app {

// The player's only clocks. Code in other folders is given the time.

[[nodiscard]] inline Instant steady_now() {
  return std::chrono::steady_clock::now();
}

/// The date where the user is, YYYY-MM-DD, by the system's clock.
[[nodiscard]] std::string today();

/// Milliseconds since the process was started, as the kernel records it.
[[nodiscard]] double since_start_ms();

}  // namespace aucast::app
