#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace aucast::bench {

// A message is a keyframe of level 2, the same bytes for every server. Its three percents, 10 to
// 99, encode its number: each is 10 plus a digit of the number in base 90.

/// How many different messages there are.
inline constexpr std::int64_t kNumbers = 90LL * 90 * 90;

/// "{1:10,2:10,4:15;250}" for number 5.
[[nodiscard]] inline std::string message(std::int64_t number, int time_ms) {
  const auto percent = [](std::int64_t digit) { return std::to_string(10 + digit % 90); };
  return "{1:" + percent(number / 8100) + ",2:" + percent(number / 90) + ",4:" + percent(number) +
         ';' + std::to_string(time_ms) + '}';
}

/// The number of a message; -1 when it is none. `inside`: the text after the opening brace.
[[nodiscard]] inline std::int64_t number_in(std::string_view inside) {
  if (inside.size() < 15 || inside[0] != '1' || inside[4] != ',' || inside[9] != ',') return -1;
  const auto percent = [inside](std::size_t at) {
    return std::int64_t{inside[at] - '0'} * 10 + (inside[at + 1] - '0') - 10;
  };
  return (percent(2) * 90 + percent(7)) * 90 + percent(12);
}

}  // namespace aucast::bench
