#pragma once

#include <charconv>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace aucast::server {

/// What is wrong with an option's word, to be put after the option's name and the word: "is not a
/// whole number from 0 to 65535". Nothing: it was read.
using Complaint = std::optional<std::string>;

/// The whole word as a number, or nothing.
template <typename T>
std::optional<T> number_of(std::string_view word) {
  T value{};
  const char* end = word.data() + word.size();
  const auto [stopped, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stopped != end) return std::nullopt;
  return value;
}

/// Reads a whole number from `low` to `high`.
template <std::integral T>
Complaint read_whole(std::string_view word, std::int64_t low, std::int64_t high, T& out) {
  const auto value = number_of<std::int64_t>(word);
  if (!value || *value < low || *value > high) {
    return "is not a whole number from " + std::to_string(low) + " to " + std::to_string(high);
  }
  out = static_cast<T>(*value);
  return std::nullopt;
}

}  // namespace aucast::server
