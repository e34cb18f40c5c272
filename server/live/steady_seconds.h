#pragma once

#include <chrono>

#include "common/time.h"

namespace aucast::server {

/// A time on the steady clock in seconds, as the readers of live sources want it.
[[nodiscard]] inline double steady_seconds(Instant time) {
  return seconds(time.time_since_epoch());
}

/// A time just after `at`, whatever the rounding: what is due at `at` is due then.
[[nodiscard]] inline Instant just_after(double at) {
  return Instant(std::chrono::floor<Duration>(std::chrono::duration<double>(at)) + Duration(1));
}

}  // namespace aucast::server
