#include "common/sources/arkit_table.h"

#include <cmath>
#include <optional>

#include "common/files.h"
#include "common/sources/csv_reader.h"
#include "common/text.h"

namespace aucast::sources {
namespace {

/// More than any curve needs: a slip of the finger.
constexpr double kGainMax = 10;

std::optional<Side> side_of(std::string_view word) {
  if (word == "L") return Side::Left;
  if (word == "R") return Side::Right;
  if (word == "B") return Side::Both;
  return std::nullopt;
}

}  // namespace

Result<ArkitTable> parse_arkit_table(std::string_view text, std::string_view file) {
  auto reader = CsvReader::open(text, file);
  if (!reader) return reader.error();
  const auto curve = reader->column("curve");
  const auto au = reader->column("au");
  const auto side = reader->column("side");
  const auto gain = reader->column("gain");
  if (!curve || !au || !side || !gain) {
    reader->refuse(std::nullopt, "expected the columns curve, au, side and gain");
    return reader->error();
  }
  ArkitTable table;
  for (auto next = reader->next(); next != CsvReader::Next::End; next = reader->next()) {
    if (next != CsvReader::Next::Row) continue;
    const auto number = reader->number(au);
    const auto factor = reader->number(gain);
    const auto which = side_of(reader->text(side));
    if (!number || *number < 1 || *number > kAuNumberMax || std::floor(*number) != *number) {
      reader->refuse(au, "expected an AU from 1 to 99");
    } else if (!which) {
      reader->refuse(side, "'" + escaped(reader->text(side)) + "' is no side; write L, R or B");
    } else if (!factor || *factor <= 0 || *factor > kGainMax) {
      reader->refuse(gain, "expected a gain above 0, at most 10");
    } else {
      table.curves.push_back(
          {std::string(reader->text(curve)), static_cast<std::uint8_t>(*number), *which, *factor});
    }
  }
  if (reader->has_errors()) return reader->error();
  return table;
}

Result<ArkitTable> load_arkit_table() {
  const auto data = find_data_folder({});
  if (!data) return data.error();
  const auto path = *data / "sources" / "arkit_to_au.csv";
  const auto text = read_file(path);
  if (!text) return text.error();
  return parse_arkit_table(*text, path.string());
}

}  // namespace aucast::sources
