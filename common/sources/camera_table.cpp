#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "common/number_of.h"
#include "common/sources/format.h"

namespace aucast::sources {
namespace {

/// AUs from here on are turns of head and eyes, which say nothing of the table's scale.
constexpr std::uint8_t kFirstTurn = 51;

struct Column {
  std::size_t index = 0;
  std::uint8_t number = 0;
  Side side = Side::Both;
};

/// "L12", "R12" or "12".
std::optional<Column> au_column(std::string_view name) {
  Column column;
  if (name.starts_with('L') || name.starts_with('R')) {
    column.side = name[0] == 'L' ? Side::Left : Side::Right;
    name.remove_prefix(1);
  }
  const auto number = number_of<std::uint8_t>(name);
  if (!number || *number < 1 || *number > kAuNumberMax) return std::nullopt;
  column.number = *number;
  return column;
}

/// Columns are AUs in percent; turns of head and eyes may be above 100.
class CameraTable final : public Format {
 public:
  explicit CameraTable(const CsvReader& table)
      : seconds_(table.column("aucast_seconds")),
        confidence_(table.column("confidence")),
        success_(table.column("success")) {
    for (std::size_t index = 0; index < table.columns().size(); ++index) {
      if (auto column = au_column(table.columns()[index])) {
        column->index = index;
        columns_.push_back(*column);
      }
    }
  }

  [[nodiscard]] bool fits() const { return seconds_ && !columns_.empty(); }
  [[nodiscard]] std::string_view name() const override { return "camera"; }
  [[nodiscard]] double native_scale() const override { return 100; }

  void read(CsvReader& row, Observation& out) const override {
    out.seconds = row.number(seconds_);
    out.confidence = row.number(confidence_).value_or(1);
    out.tracked = row.number(success_).value_or(1) > 0.5;
    for (const Column& column : columns_) {
      const auto percent = row.number(column.index);
      if (!percent) continue;
      const bool turn = column.number >= kFirstTurn;
      out.aus.push_back({column.number, column.side, turn ? *percent / 100 : *percent, !turn});
    }
  }

 private:
  std::optional<std::size_t> seconds_;
  std::optional<std::size_t> confidence_;
  std::optional<std::size_t> success_;
  std::vector<Column> columns_;
};

}  // namespace

std::unique_ptr<Format> open_camera_table(const CsvReader& table) {
  auto format = std::make_unique<CameraTable>(table);
  return format->fits() ? std::move(format) : nullptr;
}

}  // namespace aucast::sources
