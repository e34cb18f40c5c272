#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "common/result.h"

namespace aucast {

/// How many errors of one file are listed; the rest are only counted.
inline constexpr std::size_t kReportedErrorsMax = 20;

/// What is wrong with a file: the first kReportedErrorsMax errors with their places, and how many
/// more there are. `file` must outlive the list.
class ErrorList {
 public:
  explicit ErrorList(std::string_view file) : file_(file) {}

  /// Line and column count from 1.
  void add(std::size_t line, std::size_t column, std::string_view reason);
  [[nodiscard]] bool empty() const { return count_ == 0; }
  /// A BadData error with one "file:line:column: reason" per line.
  [[nodiscard]] Error error() const;
  /// Returns the same lines and empties the list.
  [[nodiscard]] std::vector<std::string> take();

 private:
  std::string_view file_;
  std::vector<std::string> first_;
  std::size_t count_ = 0;
};

}  // namespace aucast
