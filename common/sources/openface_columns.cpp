#include "common/sources/openface_columns.h"

#include <algorithm>
#include <cmath>

namespace aucast::sources {
namespace {

/// Numbers beyond are no face identifiers.
constexpr double kFaceMax = 1e9;

/// A line of sight steeper than this is no sight, and its tangent would be none.
constexpr double kGazeAngleMax = 1.5;

}  // namespace

OpenFaceColumns::OpenFaceColumns(const CsvReader& table)
    : intensities_(table, "AU", "_r"),
      presences_(table, "AU", "_c"),
      has_presences_(!presences_.empty()),
      frame_(table.column("frame")),
      face_(table.column("face_id")),
      timestamp_(table.column("timestamp")),
      confidence_(table.column("confidence")),
      success_(table.column("success")),
      distance_(table.column("pose_Tz")),
      pose_{table.column("pose_Rx"), table.column("pose_Ry"), table.column("pose_Rz")},
      gaze_angle_{table.column("gaze_angle_x"), table.column("gaze_angle_y")},
      gaze_vector_{table.column("gaze_0_x"), table.column("gaze_0_y"), table.column("gaze_0_z"),
                   table.column("gaze_1_x"), table.column("gaze_1_y"), table.column("gaze_1_z")} {
  presences_.remove(intensities_);
}

bool OpenFaceColumns::fits() const {
  return !intensities_.empty() && (confidence_ || success_ || timestamp_);
}

void OpenFaceColumns::read(CsvReader& row, Observation& out) const {
  out.seconds = row.number(timestamp_);
  out.frame = row.number(frame_);
  if (const auto face = row.number(face_); face && std::abs(*face) < kFaceMax) {
    out.face = static_cast<std::int64_t>(*face);
  }
  out.confidence = row.number(confidence_).value_or(1);
  out.tracked = row.number(success_).value_or(1) > 0.5;
  intensities_.read(row, out);
  if (!out.aus.empty()) presences_.read_presence(row, out);
  out.distance_mm = row.number(distance_);
  read_turns(row, out);
}

void OpenFaceColumns::read_turns(CsvReader& row, Observation& out) const {
  const auto pitch = row.number(pose_[0]);
  const auto yaw = row.number(pose_[1]);
  const auto roll = row.number(pose_[2]);
  const bool posed = pitch && yaw && roll;
  if (posed) out.add_head({-*yaw, -*pitch, *roll});
  const auto sight = line_of_sight(row);
  if (!sight) return;
  out.add_gaze(posed ? gaze_in_head(*sight, *pitch, *yaw, *roll) : gaze_in_head(*sight, 0, 0, 0));
}

std::optional<CameraVector> OpenFaceColumns::line_of_sight(CsvReader& row) const {
  const auto angle_x = row.number(gaze_angle_[0]);
  const auto angle_y = row.number(gaze_angle_[1]);
  if (angle_x && angle_y) {
    return CameraVector{std::tan(std::clamp(*angle_x, -kGazeAngleMax, kGazeAngleMax)),
                        std::tan(std::clamp(*angle_y, -kGazeAngleMax, kGazeAngleMax)), -1};
  }
  std::array<double, 6> both{};
  for (std::size_t index = 0; index < both.size(); ++index) {
    const auto value = row.number(gaze_vector_[index]);
    if (!value) return std::nullopt;
    both[index] = *value;
  }
  const CameraVector sight{both[0] + both[3], both[1] + both[4], both[2] + both[5]};
  // A lost face keeps 0,0,0.
  if (sight.z >= 0) return std::nullopt;
  return sight;
}

}  // namespace aucast::sources
