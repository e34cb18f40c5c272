#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "common/problems.h"

namespace aucast::face {

/// Reads the words and numbers of Waters' text files one after the other; blanks and line ends
/// separate them. An error is added to the problems with its position; the function then returns 0
/// or an empty word. The text and the problems must outlive the scanner.
class ClassicScanner {
 public:
  ClassicScanner(std::string_view text, Problems& problems) : text_(text), problems_(problems) {}

  /// Reads a whole number from `low` to `high`; `what` names it in messages, such as "the number of
  /// points".
  std::size_t count(std::string_view what, std::size_t low, std::size_t high);
  float number(std::string_view what, const Bounds& bounds = {});
  /// Reads a name of at most 64 printable characters.
  std::string word(std::string_view what);
  /// Adds a problem unless only blanks are left.
  void end();

  /// The position of the last word or number that was read.
  [[nodiscard]] LinePosition place() const { return token_place_; }
  void wrong(const std::string& text) { problems_.add(token_place_, text); }

 private:
  std::string_view next();
  bool take(std::string_view what, std::string_view& token);

  std::string_view text_;
  Problems& problems_;
  std::size_t position_ = 0;
  LinePosition here_{1, 1};
  LinePosition token_place_{1, 1};
};

}  // namespace aucast::face
