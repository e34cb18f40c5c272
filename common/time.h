#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>

namespace aucast {

/// A time on the steady clock. Pure code takes the time as an argument and never reads a clock, so
/// that tests control time.
using Instant = std::chrono::steady_clock::time_point;
using Duration = std::chrono::steady_clock::duration;
using Milliseconds = std::chrono::milliseconds;
/// A length of time with fractions, such as the difference of two times of a recogniser's rows.
using Seconds = std::chrono::duration<double>;
/// An Instant with fractions, for code that adds times of a recogniser's rows to an Instant. An
/// Instant converts to it implicitly.
using SteadyTime = std::chrono::time_point<std::chrono::steady_clock, Seconds>;

template <typename Rep, typename Period>
[[nodiscard]] constexpr double seconds(std::chrono::duration<Rep, Period> time) {
  return Seconds(time).count();
}

/// An Instant just after `at`, whatever the rounding: what is due at `at` is due then.
[[nodiscard]] constexpr Instant just_after(SteadyTime at) {
  return std::chrono::floor<Duration>(at) + Duration(1);
}

[[nodiscard]] inline std::int64_t whole_milliseconds(double seconds) {
  return std::llround(seconds * 1000);
}

}  // namespace aucast
