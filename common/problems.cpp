#include "common/problems.h"

#include <array>
#include <cstdio>

#include "common/text.h"

namespace aucast {

void Problems::add(LinePosition place, const std::string& text) {
  if (!first_) replace(place, text);
}

void Problems::replace(LinePosition place, const std::string& text) {
  first_ = Error{ErrorKind::BadData, at_place(file_, place.line, place.column, text)};
}

Result<void> Problems::result() const {
  if (first_) return *first_;
  return {};
}

bool Bounds::contain(double value) const {
  return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);
}

std::string Bounds::text() const {
  constexpr double kNoLimit = 1e6;
  const std::string from = (low_open ? "above " : "from ") + plain(low);
  if (high >= kNoLimit && low > -kNoLimit) return low_open ? from : "at least " + plain(low);
  return from + (high_open ? " and below " : " to ") + plain(high);
}

std::string plain(double value) {
  std::array<char, 32> digits{};
  const int length = std::snprintf(digits.data(), digits.size(), "%.6g", value);
  return {digits.data(), static_cast<std::size_t>(length)};
}

}  // namespace aucast
