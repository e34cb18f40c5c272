#include "client/face/classic_scanner.h"

#include <algorithm>
#include <cmath>

#include "common/number_of.h"
#include "common/text.h"

namespace aucast::face {
namespace {

constexpr std::size_t kWordMax = 64;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

}  // namespace

std::string_view ClassicScanner::next() {
  while (position_ < text_.size() && is_blank(text_[position_])) {
    if (text_[position_] == '\n') {
      here_ = {here_.line + 1, 1};
    } else {
      ++here_.column;
    }
    ++position_;
  }
  token_place_ = here_;
  const std::size_t begin = position_;
  while (position_ < text_.size() && !is_blank(text_[position_])) ++position_;
  here_.column += position_ - begin;
  return text_.substr(begin, position_ - begin);
}

bool ClassicScanner::take(std::string_view what, std::string_view& token) {
  token = next();
  if (token.empty()) wrong("the file ends before " + std::string(what));
  return !token.empty();
}

std::size_t ClassicScanner::count(std::string_view what, std::size_t low, std::size_t high) {
  std::string_view token;
  if (!take(what, token)) return 0;
  const auto value = number_of<std::size_t>(token);
  if (!value) {
    wrong(std::string(what) + " is '" + escaped(token) + "', not a whole number");
  } else if (*value < low || *value > high) {
    wrong(std::string(what) + " is " + std::to_string(*value) + ", must be from " +
          std::to_string(low) + " to " + std::to_string(high));
  } else {
    return *value;
  }
  return 0;
}

float ClassicScanner::number(std::string_view what, const Bounds& bounds) {
  std::string_view token;
  if (!take(what, token)) return 0;
  const auto value = number_of<float>(token);
  if (!value) {
    wrong(std::string(what) + " is '" + escaped(token) + "', not a number");
  } else if (!std::isfinite(*value)) {
    wrong(std::string(what) + " is not a finite number");
  } else if (!bounds.contain(*value)) {
    wrong(std::string(what) + " is " + plain(*value) + ", must be " + bounds.text());
  } else {
    return *value;
  }
  return 0;
}

std::string ClassicScanner::word(std::string_view what) {
  std::string_view token;
  if (!take(what, token)) return {};
  const bool printable =
      std::all_of(token.begin(), token.end(), [](char c) { return c > ' ' && c <= '~'; });
  if (!printable || token.size() > kWordMax) {
    wrong(std::string(what) + " '" + escaped(token) + "' must be plain text of at most 64 letters");
  }
  return std::string(token);
}

void ClassicScanner::end() {
  const std::string_view token = next();
  if (!token.empty()) {
    wrong("the file should end here, but goes on with '" + escaped(token) +
          "': is the count in its first line right?");
  }
}

}  // namespace aucast::face
