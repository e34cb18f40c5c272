#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace aucast {

/// The whole word as a number, or nothing.
template <typename T>
std::optional<T> number_of(std::string_view word) {
  T value{};
  const char* end = word.data() + word.size();
  const auto [stopped, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stopped != end) return std::nullopt;
  return value;
}

}  // namespace aucast
