#include "common/sources/pyfeat_columns.h"

namespace aucast::sources {

PyFeatColumns::PyFeatColumns(const CsvReader& table, const PyFeatAngles& angles)
    : angles_(angles),
      intensities_(table, "AU", ""),
      frame_(table.column("frame")),
      score_(table.column("FaceScore")),
      pose_{table.column("Pitch"), table.column("Yaw"), table.column("Roll")},
      gaze_{table.column("gaze_pitch"), table.column("gaze_yaw")} {}

bool PyFeatColumns::fits(const CsvReader& table) {
  return !AuColumns(table, "AU", "").empty() &&
         (table.column("FaceScore") || table.column("FaceRectX"));
}

void PyFeatColumns::read(CsvReader& row, Observation& out) const {
  out.frame = row.number(frame_);
  out.confidence = row.number(score_).value_or(1);
  intensities_.read(row, out);
  const auto pitch = row.number(pose_[0]);
  const auto yaw = row.number(pose_[1]);
  const auto roll = row.number(pose_[2]);
  const double unit = angles_.rad_per_unit;
  if (pitch && yaw && roll) {
    out.add_head({-*yaw * unit, *pitch * unit, -*roll * unit * angles_.roll_right});
  }
  const auto gaze_pitch = row.number(gaze_[0]);
  const auto gaze_yaw = row.number(gaze_[1]);
  if (gaze_pitch && gaze_yaw) out.add_gaze({-*gaze_yaw, *gaze_pitch, 0});
}

bool is_pyfeat2(const CsvReader& table) {
  return table.column("valence").has_value() || table.column("mesh_x_0").has_value();
}

}  // namespace aucast::sources
