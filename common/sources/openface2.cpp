#include "common/sources/format.h"
#include "common/sources/openface_columns.h"

namespace aucast::sources {
namespace {

/// FeatureExtraction and FaceLandmarkVidMulti of OpenFace 2.1 and 2.2: with face_id and
/// gaze_angle_x, gaze_angle_y.
class OpenFace2 final : public Format {
 public:
  explicit OpenFace2(const OpenFaceColumns& columns) : columns_(columns) {}

  [[nodiscard]] std::string_view name() const override { return "OpenFace 2"; }
  [[nodiscard]] double native_scale() const override { return 5; }
  void read(CsvReader& row, Observation& out) const override { columns_.read(row, out); }

 private:
  OpenFaceColumns columns_;
};

}  // namespace

std::unique_ptr<Format> open_openface2(const CsvReader& table) {
  const OpenFaceColumns columns(table);
  const bool own =
      table.column("face_id") || (columns.has_gaze_angles() && columns.has_presences());
  if (!columns.fits() || !own) return nullptr;
  return std::make_unique<OpenFace2>(columns);
}

}  // namespace aucast::sources
