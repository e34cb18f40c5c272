#include "common/sources/au_columns.h"

#include <algorithm>
#include <charconv>

namespace aucast::sources {
namespace {

/// The number between prefix and suffix, 0 when the name is another one.
std::uint8_t number_in(std::string_view name, std::string_view prefix, std::string_view suffix) {
  if (!name.starts_with(prefix) || !name.ends_with(suffix)) return 0;
  if (name.size() <= prefix.size() + suffix.size()) return 0;
  name = name.substr(prefix.size(), name.size() - prefix.size() - suffix.size());
  int number = 0;
  const auto [stopped, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool whole = error == std::errc() && stopped == name.data() + name.size();
  return whole && number >= 1 && number <= kAuNumberMax ? static_cast<std::uint8_t>(number) : 0;
}

}  // namespace

AuColumns::AuColumns(const CsvReader& table, std::string_view prefix, std::string_view suffix) {
  for (std::size_t index = 0; index < table.columns().size(); ++index) {
    const std::uint8_t number = number_in(table.columns()[index], prefix, suffix);
    if (number != 0 && !has(number)) columns_.push_back({number, index});
  }
}

bool AuColumns::has(std::uint8_t number) const {
  return std::any_of(columns_.begin(), columns_.end(),
                     [number](const Column& column) { return column.number == number; });
}

void AuColumns::remove(const AuColumns& other) {
  std::erase_if(columns_, [&other](const Column& column) { return other.has(column.number); });
}

void AuColumns::read(CsvReader& row, Observation& out) const {
  for (const Column& column : columns_) {
    const auto value = row.number(column.index);
    if (value) out.aus.push_back({column.number, Side::Both, *value, true});
  }
}

void AuColumns::read_presence(CsvReader& row, Observation& out) const {
  for (const Column& column : columns_) {
    const auto value = row.number(column.index);
    if (!value) continue;
    const double intensity = *value > 0.5 ? kPresentIntensity : 0;
    out.aus.push_back({column.number, Side::Both, intensity, false});
  }
}

}  // namespace aucast::sources
