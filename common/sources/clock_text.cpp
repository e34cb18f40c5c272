#include "common/sources/clock_text.h"

#include <array>
#include <span>

#include "common/sources/csv_reader.h"

namespace aucast::sources {
namespace {

/// As many numbers as `parts` has, below 1000, with colons between them.
bool split_numbers(std::string_view text, std::span<double> parts) {
  for (std::size_t index = 0; index < parts.size(); ++index) {
    const std::size_t colon = text.find(':');
    const bool last = index + 1 == parts.size();
    if (last != (colon == std::string_view::npos)) return false;
    const auto value = parse_number(text.substr(0, colon), true);
    if (!value || *value < 0 || *value >= 1000) return false;
    parts[index] = *value;
    if (!last) text.remove_prefix(colon + 1);
  }
  return parts[0] < 24 && parts[1] < 60 && parts[2] < 61;
}

}  // namespace

std::optional<Timecode> parse_timecode(std::string_view text) {
  std::array<double, 4> parts{};
  if (!split_numbers(text, parts)) return std::nullopt;
  return Timecode{parts[0] * 3600 + parts[1] * 60 + parts[2], parts[3]};
}

std::optional<double> parse_clock(std::string_view text) {
  std::array<double, 3> parts{};
  if (!split_numbers(text, parts)) return std::nullopt;
  return parts[0] * 3600 + parts[1] * 60 + parts[2];
}

}  // namespace aucast::sources
