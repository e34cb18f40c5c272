#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "common/sources/au_columns.h"
#include "common/sources/format.h"

namespace aucast::sources {
namespace {

/// A line of sight steeper than this is no sight, and its tangent would be none.
constexpr double kGazeAngleMax = 1.5;

/// OpenFace 1.x (blanks after the commas, no face_id, gaze as two vectors), OpenFace 2 (face_id,
/// gaze angles) and FACSvatar's cleaned form (gaze angles, head rotation and AU intensities alone,
/// 0 to 1 or as OpenFace had them). Pose: radians, R = Rx Ry Rz in camera space (x right in the
/// image, y down, z away), so that a positive pitch is down, a positive yaw the subject's right, a
/// positive roll the subject's left; checked against the landmarks of a recording. pose_Tz is the
/// distance from the camera in millimetres. Gaze: a positive angle is the image's right, the
/// subject's left, and down.
class OpenFace final : public Format {
 public:
  explicit OpenFace(const CsvReader& table)
      : intensities_(table, "AU", "_r"),
        presences_(table, "AU", "_c"),
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
    const bool presences = !presences_.empty();
    if (face_ || (gaze_angle_[0] && gaze_angle_[1] && presences)) {
      name_ = "OpenFace 2";
    } else if (presences || gaze_vector_[0] || table.column("pose_Tx")) {
      name_ = "OpenFace 1";
    } else {
      name_ = "FACSvatar";
      scale_ = 0;
    }
    presences_.remove(intensities_);
  }

  /// There is what makes it OpenFace: AU intensities, and a time, a confidence or a success.
  [[nodiscard]] bool fits() const {
    return !intensities_.empty() && (confidence_ || success_ || timestamp_);
  }
  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] double native_scale() const override { return scale_; }

  void read(CsvReader& row, Observation& out) const override {
    out.seconds = row.number(timestamp_);
    out.frame = row.number(frame_);
    out.name_face(row.number(face_));
    out.confidence = row.number(confidence_).value_or(1);
    out.tracked = row.number(success_).value_or(1) > 0.5;
    intensities_.read(row, out);
    if (!out.aus.empty()) presences_.read_presence(row, out);
    out.distance_mm = row.number(distance_);
    read_turns(row, out);
  }

 private:
  /// The line of sight is one of the room: without the head's rotation nothing is known of the eyes
  /// in the head, unless the table never has one.
  void read_turns(CsvReader& row, Observation& out) const {
    const bool has_pose = pose_[0] && pose_[1] && pose_[2];
    const auto pitch = row.number(pose_[0]);
    const auto yaw = row.number(pose_[1]);
    const auto roll = row.number(pose_[2]);
    const bool posed = pitch && yaw && roll;
    if (posed) out.add_head({-*yaw, -*pitch, *roll});
    if (has_pose && !posed) return;
    if (const auto sight = line_of_sight(row)) {
      out.add_gaze(posed ? gaze_in_head(*sight, *pitch, *yaw, *roll)
                         : gaze_in_head(*sight, 0, 0, 0));
    }
  }

  [[nodiscard]] std::optional<CameraVector> line_of_sight(CsvReader& row) const {
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

  std::string_view name_;
  double scale_ = 5;
  AuColumns intensities_;
  AuColumns presences_;
  std::optional<std::size_t> frame_, face_, timestamp_, confidence_, success_, distance_;
  std::array<std::optional<std::size_t>, 3> pose_;
  std::array<std::optional<std::size_t>, 2> gaze_angle_;
  std::array<std::optional<std::size_t>, 6> gaze_vector_;
};

}  // namespace

std::unique_ptr<Format> open_openface(const CsvReader& table) {
  auto format = std::make_unique<OpenFace>(table);
  if (!format->fits()) return nullptr;
  return format;
}

}  // namespace aucast::sources
