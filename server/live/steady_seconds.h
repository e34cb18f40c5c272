#pragma once

#include <chrono>

#include "common/time.h"

namespace aucast::server {

/// The steady clock in seconds, which is what the readers of live sources count by.
[[nodiscard]] inline double steady_seconds(Instant time) {
  return seconds(time.time_since_epoch());
}

/// Just after `at`, however it is rounded: what is waited for is due then.
[[nodiscard]] inline Instant just_after(double at) {
  return Instant(std::chrono::floor<Duration>(std::chrono::duration<double>(at)) + Duration(1));
}

}  // namespace aucast::server
