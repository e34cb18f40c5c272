#include "common/sources/per_au.h"

#include <charconv>

namespace aucast::sources {

std::optional<AuName> parse_au_name(std::string_view text) {
  AuName au;
  if (text.starts_with('L') || text.starts_with('R')) {
    au.side = text.front() == 'L' ? Side::Left : Side::Right;
    text.remove_prefix(1);
  }
  int number = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stopped != end || number < 1 || number > kAuNumberMax) {
    return std::nullopt;
  }
  au.number = static_cast<std::uint8_t>(number);
  return au;
}

std::string au_name_text(const AuName& au) {
  const char* side = au.side == Side::Left ? "L" : au.side == Side::Right ? "R" : "";
  return side + std::to_string(au.number);
}

void PerAu::set_all(double value) {
  all_ = value;
  values_.fill(value);
}

void PerAu::set(const AuName& au, double value) {
  if (au.side != Side::Right) values_[channel_of(au.number, false)] = value;
  if (au.side != Side::Left) values_[channel_of(au.number, true)] = value;
}

std::vector<std::pair<AuName, double>> PerAu::exceptions() const {
  std::vector<std::pair<AuName, double>> found;
  for (std::uint8_t number = 1; number < kAuCount; ++number) {
    const double left = of(number, false);
    const double right = of(number, true);
    if (left == right) {
      if (left != all_) found.push_back({{number, Side::Both}, left});
      continue;
    }
    if (left != all_) found.push_back({{number, Side::Left}, left});
    if (right != all_) found.push_back({{number, Side::Right}, right});
  }
  return found;
}

}  // namespace aucast::sources
