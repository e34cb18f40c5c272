#include "common/sources/openface_table.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <cstdio>
#include <utility>

#include "common/action_unit.h"
#include "common/au_numbers.h"
#include "common/sources/observation.h"
#include "common/sources/signals.h"

namespace aucast::sources {
namespace {

/// The AUs that OpenFace 2 has intensities of.
constexpr std::array<std::size_t, 17> kOpenFaceAus{1,  2,  4,  5,  6,  7,  9,  10, 12,
                                                   14, 15, 17, 20, 23, 25, 26, 45};
/// Intensity 1 on OpenFace's scale.
constexpr double kFull = 5;

/// From the camera to a head that leans neither forward nor back.
constexpr double kUsualDistanceMm = 600;

using AuIntensities = std::array<double, kAuCount>;

AuIntensities stronger_sides(const AuFrame& frame) {
  AuIntensities stronger{};
  for (std::size_t number = 0; number < stronger.size(); ++number) {
    stronger[number] = std::max(frame.left[number], frame.right[number]);
  }
  return stronger;
}

template <typename... Values>
void append(std::string& text, const char* format, Values... values) {
  std::array<char, 64> buffer{};
  const int length = std::snprintf(buffer.data(), buffer.size(), format, values...);
  text.append(buffer.data(), static_cast<std::size_t>(length));
}

class Writer {
 public:
  explicit Writer(const protocol::StreamFile& stream) {
    for (const std::size_t number : kOpenFaceAus) columns_.set(number);
    for (const protocol::Keyframe& keyframe : stream.keyframes) {
      for (const AuTerm& term : keyframe.terms) {
        // AUs with an opposite turn the head or the eyes: they are pose and gaze.
        if (term.number != 0 && opposite_of(term.number) == 0) columns_.set(term.number);
      }
    }
    table_.text =
        "frame,face_id,timestamp,confidence,success,gaze_angle_x,gaze_angle_y,"
        "pose_Tz,pose_Rx,pose_Ry,pose_Rz";
    for (std::size_t number = 0; number < columns_.size(); ++number) {
      if (columns_.test(number)) append(table_.text, ",AU%02zu_r", number);
    }
    table_.text += '\n';
  }

  void row(double ms, const AuIntensities& face) {
    append(table_.text, "%zu,0,%.3f,1.00,1", ++table_.rows, ms / 1000);
    write_turns(face);
    for (std::size_t number = 0; number < columns_.size(); ++number) {
      if (columns_.test(number)) append(table_.text, ",%.2f", face[number] * kFull);
    }
    table_.text += '\n';
  }

  void count_uneven() { ++table_.uneven; }
  [[nodiscard]] OpenFaceTable finish() && { return std::move(table_); }

 private:
  /// Signs as openface.cpp reads them.
  void write_turns(const AuIntensities& face) {
    const double left = (face[kHeadLeft] - face[kHeadRight]) * kYawDegrees * kRadPerDegree;
    const double up = (face[kHeadUp] - face[kHeadDown]) * kPitchDegrees * kRadPerDegree;
    const double tilt = (face[kHeadTiltLeft] - face[kHeadTiltRight]) * kTiltDegrees * kRadPerDegree;
    const Rotation eyes{(face[kEyesLeft] - face[kEyesRight]) * kGazeYawDegrees * kRadPerDegree,
                        (face[kEyesUp] - face[kEyesDown]) * kGazePitchDegrees * kRadPerDegree, 0};
    const CameraVector sight = sight_in_room(eyes, -up, -left, tilt);
    // + 0.0 makes 0 of -0.
    append(table_.text, ",%.6f,%.6f", std::atan2(sight.x, -sight.z) + 0.0,
           std::atan2(sight.y, -sight.z) + 0.0);
    append(table_.text, ",%.1f",
           kUsualDistanceMm + (face[kHeadBack] - face[kHeadForward]) * kMillimetresPerUnit);
    append(table_.text, ",%.6f,%.6f,%.6f", -up + 0.0, -left + 0.0, tilt);
  }

  std::bitset<kAuCount> columns_;
  OpenFaceTable table_;
};

}  // namespace

OpenFaceTable write_openface_table(const protocol::StreamFile& stream, std::uint32_t keyframe_ms) {
  Writer writer(stream);
  AuIntensities from{};
  std::uint64_t begin_ms = 0;
  for (std::size_t index = 0; index < stream.keyframes.size(); ++index) {
    const protocol::Keyframe& keyframe = stream.keyframes[index];
    const AuFrame frame = frame_from_terms(keyframe.terms);
    const AuIntensities to = stronger_sides(frame);
    const std::uint32_t time_ms = keyframe.time_ms.value_or(keyframe_ms);
    const bool last = index + 1 == stream.keyframes.size();
    const bool passed = !last && stream.keyframes[index + 1].time_ms.value_or(keyframe_ms) == 0;
    const std::uint32_t steps = std::max(1U, (time_ms + kRowMsMax - 1) / kRowMsMax);
    for (std::uint32_t step = 1; step <= steps; ++step) {
      if (step == steps && passed) break;
      const double share = static_cast<double>(step) / steps;
      AuIntensities face{};
      for (std::size_t number = 0; number < face.size(); ++number) {
        face[number] =
            step == steps ? to[number] : from[number] + (to[number] - from[number]) * share;
      }
      writer.row(static_cast<double>(begin_ms) + time_ms * share, face);
    }
    if (!passed && frame.left != frame.right) writer.count_uneven();
    from = to;
    begin_ms += time_ms;
  }
  return std::move(writer).finish();
}

}  // namespace aucast::sources
