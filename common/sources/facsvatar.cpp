#include "common/sources/format.h"
#include "common/sources/openface_columns.h"

namespace aucast::sources {
namespace {

/// The cleaned form that FACSvatar keeps: times, gaze angles, head rotation and AU intensities
/// alone, 0 to 1 or as OpenFace had them; which of both, only the values tell.
class Facsvatar final : public Format {
 public:
  explicit Facsvatar(const OpenFaceColumns& columns) : columns_(columns) {}

  [[nodiscard]] std::string_view name() const override { return "FACSvatar"; }
  [[nodiscard]] double native_scale() const override { return 0; }
  void read(CsvReader& row, Observation& out) const override { columns_.read(row, out); }

 private:
  OpenFaceColumns columns_;
};

}  // namespace

std::unique_ptr<Format> open_facsvatar(const CsvReader& table) {
  const OpenFaceColumns columns(table);
  const bool raw = columns.has_presences() || columns.has_gaze_vectors() ||
                   table.column("face_id") || table.column("pose_Tx");
  if (!columns.fits() || raw) return nullptr;
  return std::make_unique<Facsvatar>(columns);
}

}  // namespace aucast::sources
