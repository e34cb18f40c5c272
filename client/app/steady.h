#pragma once

#include "common/time.h"

namespace aucast::app {

// The player's only clock. Code in other folders is given the time.

[[nodiscard]] inline Instant steady_now() {
  return std::chrono::steady_clock::now();
}

/// Milliseconds since the process was started, as the kernel records it.
[[nodiscard]] double since_start_ms();

}  // namespace aucast::app
