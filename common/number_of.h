#pragma once

#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace aucast {
namespace detail {

using std::from_chars;
#if !defined(__cpp_lib_to_chars)
/// emscripten's from_chars reads whole numbers only; this one accepts the same as the standard's.
template <std::floating_point T>
std::from_chars_result from_chars(const char* begin, const char* end, T& value) {
  const std::string word(begin, end);
  const bool plain = word.find_first_not_of("+-.0123456789eEinfatyINFATY") == std::string::npos;
  if (word.empty() || !plain || word.front() == '+') return {begin, std::errc::invalid_argument};
  char* stopped = nullptr;
  value = static_cast<T>(std::strtod(word.c_str(), &stopped));
  if (std::isinf(value) && word.find_first_of("iI") == std::string::npos) {
    return {begin, std::errc::result_out_of_range};
  }
  return {begin + (stopped - word.c_str()), std::errc()};
}
#endif

}  // namespace detail

/// The whole word as a number; nullopt when it is not a number.
template <typename T>
[[nodiscard]] std::optional<T> number_of(std::string_view word) {
  T value{};
  const char* end = word.data() + word.size();
  const auto [stopped, error] = detail::from_chars(word.data(), end, value);
  if (error != std::errc() || stopped != end) return std::nullopt;
  return value;
}

}  // namespace aucast
