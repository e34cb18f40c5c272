#include "common/sources/au_columns.h"
#include "common/sources/format.h"

namespace aucast::sources {
namespace {

/// LibreFace: au_N_intensity from 0 to 5, au_N as presence, times in milliseconds. Its head pose is
/// left out: which way its signs go is not documented, and a wrong turn is worse than none.
class LibreFace final : public Format {
 public:
  explicit LibreFace(const CsvReader& table)
      : intensities_(table, "au_", "_intensity"),
        presences_(table, "au_", ""),
        frame_(table.column("frame_idx")),
        milliseconds_(table.column("frame_time_in_ms")),
        score_(table.column("face_detection_score")) {
    presences_.remove(intensities_);
  }

  [[nodiscard]] bool fits() const { return !intensities_.empty(); }
  [[nodiscard]] std::string_view name() const override { return "LibreFace"; }
  [[nodiscard]] double native_scale() const override { return 5; }

  void read(CsvReader& row, Observation& out) const override {
    if (const auto milliseconds = row.number(milliseconds_)) out.seconds = *milliseconds / 1000;
    out.frame = row.number(frame_);
    out.confidence = row.number(score_).value_or(1);
    intensities_.read(row, out);
    if (!out.aus.empty()) presences_.read_presence(row, out);
  }

 private:
  AuColumns intensities_;
  AuColumns presences_;
  std::optional<std::size_t> frame_, milliseconds_, score_;
};

}  // namespace

std::unique_ptr<Format> open_libreface(const CsvReader& table) {
  auto format = std::make_unique<LibreFace>(table);
  if (!format->fits()) return nullptr;
  return format;
}

}  // namespace aucast::sources
