#pragma once

#include <array>
#include <optional>

#include "common/sources/au_columns.h"

namespace aucast::sources {

/// The columns that OpenFace 1.x, OpenFace 2 and FACSvatar's cleaned form share. Pose: radians,
/// R = Rx Ry Rz in camera space (x right in the image, y down, z away), so that a positive pitch is
/// down, a positive yaw the subject's right, a positive roll the subject's left; checked against
/// the landmarks of a recording. pose_Tz is the distance from the camera in millimetres. Gaze: a
/// positive angle is the image's right, the subject's left, and down.
class OpenFaceColumns {
 public:
  explicit OpenFaceColumns(const CsvReader& table);

  /// There is what makes it OpenFace: AU intensities, and a confidence or a success.
  [[nodiscard]] bool fits() const;
  [[nodiscard]] bool has_presences() const { return has_presences_; }
  [[nodiscard]] bool has_gaze_angles() const { return gaze_angle_[0] && gaze_angle_[1]; }
  [[nodiscard]] bool has_gaze_vectors() const { return gaze_vector_[0].has_value(); }
  void read(CsvReader& row, Observation& out) const;

 private:
  void read_turns(CsvReader& row, Observation& out) const;
  [[nodiscard]] std::optional<CameraVector> line_of_sight(CsvReader& row) const;

  AuColumns intensities_;
  AuColumns presences_;
  bool has_presences_ = false;
  std::optional<std::size_t> frame_, face_, timestamp_, confidence_, success_;
  std::optional<std::size_t> distance_;
  std::array<std::optional<std::size_t>, 3> pose_;
  std::array<std::optional<std::size_t>, 2> gaze_angle_;
  std::array<std::optional<std::size_t>, 6> gaze_vector_;
};

}  // namespace aucast::sources
