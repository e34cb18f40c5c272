#include "common/sources/au_columns.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace aucast::sources {
namespace {

/// The AU's number in a name, 0 when the name is another one; `rest` is what follows it.
std::uint8_t number_in(std::string_view name, std::string_view prefix, std::string_view& rest) {
  const std::size_t begin = name.find(prefix);
  if (begin == std::string_view::npos) return 0;
  const std::string_view digits = name.substr(begin + prefix.size());
  int number = 0;
  const auto [stopped, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || number < 1 || number > kAuNumberMax) return 0;
  rest = digits.substr(static_cast<std::size_t>(stopped - digits.data()));
  return static_cast<std::uint8_t>(number);
}

/// What FaceReader writes for an intensity it scored by FACS.
std::optional<double> scored(std::string_view word) {
  if (word == "NotActive") return 0;
  if (word.size() != 1 || word.front() > 'E') return std::nullopt;
  const auto percent = percent_of_letter(word.front());
  if (!percent) return std::nullopt;
  return *percent / 100.0;
}

}  // namespace

AuColumns::AuColumns(const CsvReader& table, std::string_view prefix, std::string_view suffix)
    : letters_(suffix == kAnySuffix) {
  for (std::size_t index = 0; index < table.columns().size(); ++index) {
    const std::string_view name = table.columns()[index];
    std::string_view rest;
    const std::uint8_t number = number_in(name, prefix, rest);
    if (number == 0) continue;
    if (letters_) {
      const bool left = name.find("Left") != std::string_view::npos;
      const bool right = name.find("Right") != std::string_view::npos;
      add(number, left ? Side::Left : right ? Side::Right : Side::Both, index);
    } else if (rest == suffix && name.starts_with(prefix)) {
      add(number, Side::Both, index);
    }
  }
}

void AuColumns::add(std::uint8_t number, Side side, std::size_t index) {
  if (has(number, side)) return;
  columns_.insert(side == Side::Both ? columns_.begin() : columns_.end(), {number, side, index});
}

bool AuColumns::has(std::uint8_t number, Side side) const {
  return std::any_of(columns_.begin(), columns_.end(), [=](const Column& column) {
    return column.number == number && column.side == side;
  });
}

void AuColumns::remove(const AuColumns& other) {
  std::erase_if(columns_,
                [&](const Column& column) { return other.has(column.number, column.side); });
}

void AuColumns::read(CsvReader& row, Observation& out) const {
  for (const Column& column : columns_) {
    const auto intensity = letters_ ? scored(row.text(column.index)) : std::nullopt;
    if (intensity) {
      out.aus.push_back({column.number, column.side, *intensity, false});
    } else if (const auto value = row.number(column.index)) {
      out.aus.push_back({column.number, column.side, *value, true});
    }
  }
}

void AuColumns::read_presence(CsvReader& row, Observation& out) const {
  for (const Column& column : columns_) {
    const auto value = row.number(column.index);
    if (!value) continue;
    const double intensity = *value > 0.5 ? kPresentIntensity : 0;
    out.aus.push_back({column.number, column.side, intensity, false});
  }
}

void AuColumns::read_evidence(CsvReader& row, Observation& out) const {
  for (const Column& column : columns_) {
    const auto evidence = row.number(column.index);
    if (!evidence) continue;
    const double probability = 1 / (1 + std::pow(10, -*evidence));
    out.aus.push_back({column.number, column.side, std::max(0.0, 2 * probability - 1), false});
  }
}

}  // namespace aucast::sources
