#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>

namespace aucast {

/// A time on the steady clock. Pure code takes it as an argument and never reads a clock, so that
/// tests control it.
using Instant = std::chrono::steady_clock::time_point;
using Duration = std::chrono::steady_clock::duration;
using Milliseconds = std::chrono::milliseconds;
/// An Instant as a number: seconds since the clock's zero. For code that compares it with the times
/// of a recogniser's rows, which are numbers.
using SteadySeconds = double;

[[nodiscard]] constexpr double seconds(Duration time) {
  return std::chrono::duration<double>(time).count();
}

[[nodiscard]] inline std::int64_t whole_milliseconds(double seconds) {
  return std::llround(seconds * 1000);
}

}  // namespace aucast
