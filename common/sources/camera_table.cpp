#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "common/au_numbers.h"
#include "common/sources/format.h"
#include "common/sources/per_au.h"

namespace aucast::sources {
namespace {

/// AUs from here on are turns of head and eyes, which say nothing of the table's scale.
constexpr std::uint8_t kFirstTurn = kHeadLeft;

struct Column {
  std::size_t index = 0;
  AuName au;
};

/// Columns are AUs in percent; turns of head and eyes may be above 100.
class CameraTable final : public Format {
 public:
  explicit CameraTable(const CsvReader& table)
      : seconds_(table.column("aucast_seconds")),
        confidence_(table.column("confidence")),
        success_(table.column("success")),
        face_(table.column("face_id")) {
    for (std::size_t index = 0; index < table.columns().size(); ++index) {
      if (const auto au = parse_au_name(table.columns()[index])) columns_.push_back({index, *au});
    }
  }

  [[nodiscard]] bool fits() const { return seconds_ && !columns_.empty(); }
  [[nodiscard]] std::string_view name() const override { return "camera"; }
  [[nodiscard]] double native_scale() const override { return 100; }

  void read(CsvReader& row, Observation& out) const override {
    out.seconds = row.number(seconds_);
    out.confidence = row.number(confidence_).value_or(1);
    out.tracked = row.number(success_).value_or(1) > 0.5;
    out.name_face(row.number(face_));
    for (const Column& column : columns_) {
      const auto percent = row.number(column.index);
      if (!percent) continue;
      const bool turn = column.au.number >= kFirstTurn;
      out.aus.push_back(
          {column.au.number, column.au.side, turn ? *percent / 100 : *percent, !turn});
    }
  }

 private:
  std::optional<std::size_t> seconds_;
  std::optional<std::size_t> confidence_;
  std::optional<std::size_t> success_;
  std::optional<std::size_t> face_;
  std::vector<Column> columns_;
};

}  // namespace

std::unique_ptr<Format> open_camera_table(const CsvReader& table) {
  auto format = std::make_unique<CameraTable>(table);
  return format->fits() ? std::move(format) : nullptr;
}

}  // namespace aucast::sources
