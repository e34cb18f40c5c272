#include "common/sources/format.h"
#include "common/sources/openface_columns.h"

namespace aucast::sources {
namespace {

/// OpenFace 1.x and 2.0: blanks after the commas, no face_id, gaze as two vectors and no angles.
class OpenFace1 final : public Format {
 public:
  explicit OpenFace1(const OpenFaceColumns& columns) : columns_(columns) {}

  [[nodiscard]] std::string_view name() const override { return "OpenFace 1"; }
  [[nodiscard]] double native_scale() const override { return 5; }
  void read(CsvReader& row, Observation& out) const override { columns_.read(row, out); }

 private:
  OpenFaceColumns columns_;
};

}  // namespace

std::unique_ptr<Format> open_openface1(const CsvReader& table) {
  const OpenFaceColumns columns(table);
  const bool own = columns.has_presences() || columns.has_gaze_vectors() || table.column("pose_Tx");
  if (!columns.fits() || !own || table.column("face_id")) return nullptr;
  return std::make_unique<OpenFace1>(columns);
}

}  // namespace aucast::sources
