#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "common/result.h"

namespace aucast {

/// Errors of one file that are listed one by one.
inline constexpr std::size_t kReportedErrorsMax = 20;

/// What is wrong with a file: the first kReportedErrorsMax errors with their places, and how many
/// more there are. `file` must outlive it.
class ErrorList {
 public:
  explicit ErrorList(std::string_view file) : file_(file) {}

  /// Line and column count from 1.
  void add(std::size_t line, std::size_t column, std::string_view reason);
  [[nodiscard]] bool empty() const { return count_ == 0; }
  /// BadData with "file:line:column: reason" on a line each.
  [[nodiscard]] Error error() const;
  /// The lines of the first ones; all are forgotten.
  [[nodiscard]] std::vector<std::string> take();

 private:
  std::string_view file_;
  std::vector<std::string> first_;
  std::size_t count_ = 0;
};

}  // namespace aucast
