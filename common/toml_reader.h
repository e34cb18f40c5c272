#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/problems.h"
#include "common/toml_document.h"

namespace aucast {

/// Reads a table key by key. A value that is missing, of the wrong type or out of range is a
/// problem, which is noted with its place; the caller gets a harmless value. finish() reports keys
/// that were never asked for, with the nearest one that was: also in place of a missing key that
/// they are near to. The table and the problems must outlive it.
class TableReader {
 public:
  TableReader(const TomlValue& table, Problems& problems) : table_(table), problems_(problems) {}

  [[nodiscard]] bool has(std::string_view key) const;
  [[nodiscard]] LinePosition place_of(std::string_view key) const;

  // Required values.
  std::string text(std::string_view key);
  double real(std::string_view key, const Bounds& bounds = {});
  float number(std::string_view key, const Bounds& bounds = {});
  int integer(std::string_view key, int low, int high);
  std::vector<int> integers(std::string_view key, int low, int high);  ///< not empty
  /// An array of exactly N numbers.
  template <std::size_t N>
  std::array<float, N> numbers(std::string_view key, const Bounds& bounds = {}) {
    std::array<float, N> values{};
    read_numbers(key, values, bounds);
    return values;
  }

  // Values with a default.
  std::string text_or(std::string_view key, std::string_view fallback);
  float number_or(std::string_view key, float fallback, const Bounds& bounds = {});
  bool boolean_or(std::string_view key, bool fallback);
  int integer_or(std::string_view key, int fallback, int low, int high);
  /// A text that must be one of `words`; returns its index, such as the value of an enumeration.
  std::size_t word_or(std::string_view key, std::size_t fallback,
                      std::span<const std::string_view> words);
  /// An array of texts; empty when there is none.
  std::vector<std::string> texts(std::string_view key);
  const TomlValue* table_if(std::string_view key);
  /// The tables of [[key]]; empty when there are none.
  std::vector<const TomlValue*> tables(std::string_view key);
  /// A value of any kind; null when it is missing.
  const TomlValue* value_if(std::string_view key);

  void wrong(std::string_view key, const std::string& text);
  void finish();

 private:
  const TomlValue* needed(std::string_view key, TomlValue::Kind kind);
  double checked_number(const TomlValue& value, std::string_view key, const Bounds& bounds);
  void read_numbers(std::string_view key, std::span<float> values, const Bounds& bounds);

  const TomlValue& table_;
  Problems& problems_;
  std::vector<std::string> asked_;
  std::optional<std::string> missing_;  ///< a required key, whose lack was the file's first problem
};

}  // namespace aucast
