#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "common/result.h"

namespace aucast {

/// Line and column in a file, both from 1.
struct LinePosition {
  std::size_t line = 0;
  std::size_t column = 0;
};

/// Keeps the first problem of a file, so that code that reads fields need not stop at each error.
class Problems {
 public:
  explicit Problems(std::string file) : file_(std::move(file)) {}

  void add(LinePosition place, const std::string& text);
  /// Says the first problem in another way.
  void replace(LinePosition place, const std::string& text);
  [[nodiscard]] bool none() const { return !first_.has_value(); }
  /// Success, or a BadData error with the first problem, "file:line:column: ...".
  [[nodiscard]] Result<void> result() const;

 private:
  std::string file_;
  std::optional<Error> first_;
};

/// The range of a number. An open bound does not belong to the range.
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

/// A number for a message, with at most six digits: 0.5, 4, 95.
[[nodiscard]] std::string plain(double value);

}  // namespace aucast
