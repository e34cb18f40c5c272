#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "common/result.h"
#include "common/toml_document.h"

namespace aucast::face {

/// Keeps the first thing that is wrong with a file.
class Problems {
 public:
  explicit Problems(std::string file) : file_(std::move(file)) {}

  void add(Place place, const std::string& text);
  [[nodiscard]] bool none() const { return !first_.has_value(); }
  /// Success, or BadData "file:line:column: ..." of the first problem.
  [[nodiscard]] Result<void> result() const;

 private:
  std::string file_;
  std::optional<Error> first_;
};

/// What a number may be. Bounds that are open are not part of it.
struct Bounds {
  double low = -1e6;
  double high = 1e6;
  bool low_open = false;
  bool high_open = false;

  [[nodiscard]] static constexpr Bounds above(double low) { return {low, 1e6, true, false}; }
  [[nodiscard]] static constexpr Bounds between(double low, double high) { return {low, high}; }
  [[nodiscard]] static constexpr Bounds inside(double low, double high) {
    return {low, high, true, true};
  }
  [[nodiscard]] bool contain(double value) const;  ///< false for NaN
  [[nodiscard]] std::string text() const;          ///< "from 0 to 2", "above 0"
};

/// Reads one table key by key. What is missing, of the wrong type or out of range goes to the
/// problems with its place, and a harmless value comes back, so that a reader is a plain list of
/// fields. finish() reports keys that nobody asked for, with the nearest one that was.
/// The table and the problems must outlive it.
class TableReader {
 public:
  TableReader(const TomlValue& table, Problems& problems) : table_(table), problems_(problems) {}

  [[nodiscard]] bool has(std::string_view key) const;
  [[nodiscard]] Place place() const { return table_.place; }
  [[nodiscard]] Place place_of(std::string_view key) const;

  // Needed fields.
  std::string text(std::string_view key);
  float number(std::string_view key, const Bounds& bounds = {});
  int integer(std::string_view key, int low, int high);
  glm::vec3 point(std::string_view key, const Bounds& bounds = {});
  glm::vec2 pair(std::string_view key, const Bounds& bounds = {});
  std::vector<int> integers(std::string_view key, int low, int high);

  // Fields with a default.
  std::string text_or(std::string_view key, std::string_view fallback);
  float number_or(std::string_view key, float fallback, const Bounds& bounds = {});
  bool boolean_or(std::string_view key, bool fallback);
  const TomlValue* table_if(std::string_view key);
  /// The tables of [[key]]; empty when there are none.
  std::vector<const TomlValue*> tables(std::string_view key);
  /// A value of any kind.
  const TomlValue* value_if(std::string_view key);

  void wrong(std::string_view key, const std::string& text);
  void finish();

 private:
  const TomlValue* find(std::string_view key);
  void unknown(const TomlValue::Entry& entry);
  const TomlValue* needed(std::string_view key, TomlValue::Kind kind);
  float checked_number(const TomlValue& value, std::string_view key, const Bounds& bounds);
  std::vector<float> numbers(std::string_view key, std::size_t count, const Bounds& bounds);

  const TomlValue& table_;
  Problems& problems_;
  std::vector<std::string> asked_;
};

/// A number for a message, without needless digits: 0.5, 4, 95.
[[nodiscard]] std::string plain(double value);

/// "; did you mean X?" for the nearest of the known words, or nothing.
[[nodiscard]] std::string did_you_mean(std::string_view word,
                                       const std::vector<std::string>& known);

}  // namespace aucast::face
