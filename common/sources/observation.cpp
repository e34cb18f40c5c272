#include "common/sources/observation.h"

#include <algorithm>
#include <cmath>

#include "common/au_numbers.h"

namespace aucast::sources {
namespace {

void add_pair(std::vector<AuValue>& aus, std::uint8_t number, std::uint8_t opposite, double rad,
              double degrees_full) {
  const double intensity = rad / (degrees_full * kRadPerDegree);
  aus.push_back({number, Side::Both, std::max(intensity, 0.0), false});
  aus.push_back({opposite, Side::Both, std::max(-intensity, 0.0), false});
}

}  // namespace

void Observation::clear() {
  seconds.reset();
  frame.reset();
  face.reset();
  confidence = 1;
  tracked = true;
  distance_mm.reset();
  aus.clear();
}

void Observation::name_face(std::optional<double> identifier) {
  constexpr double kFaceMax = 1e9;
  if (!identifier || !(std::abs(*identifier) < kFaceMax)) return;
  face = static_cast<std::int64_t>(*identifier);
}

void Observation::add_head(const Rotation& turn) {
  add_pair(aus, kHeadLeft, kHeadRight, turn.left_rad, kYawDegrees);
  add_pair(aus, kHeadUp, kHeadDown, turn.up_rad, kPitchDegrees);
  add_pair(aus, kHeadTiltLeft, kHeadTiltRight, turn.tilt_left_rad, kTiltDegrees);
}

void Observation::add_gaze(const Rotation& turn) {
  add_pair(aus, kEyesLeft, kEyesRight, turn.left_rad, kGazeYawDegrees);
  add_pair(aus, kEyesUp, kEyesDown, turn.up_rad, kGazePitchDegrees);
}

Rotation gaze_in_head(const CameraVector& sight, double pitch, double yaw, double roll) {
  // The inverse of Rx Ry Rz: back about x, then y, then z.
  const double y1 = std::cos(pitch) * sight.y + std::sin(pitch) * sight.z;
  const double z1 = -std::sin(pitch) * sight.y + std::cos(pitch) * sight.z;
  const double x2 = std::cos(yaw) * sight.x - std::sin(yaw) * z1;
  const double z2 = std::sin(yaw) * sight.x + std::cos(yaw) * z1;
  const double x3 = std::cos(roll) * x2 + std::sin(roll) * y1;
  const double y3 = -std::sin(roll) * x2 + std::cos(roll) * y1;
  return {std::atan2(x3, -z2), -std::atan2(y3, -z2), 0};
}

CameraVector sight_in_room(const Rotation& eyes, double pitch, double yaw, double roll) {
  // gaze_in_head() backwards: by z, then y, then x.
  const double x3 = std::tan(eyes.left_rad);
  const double y3 = -std::tan(eyes.up_rad);
  const double x2 = std::cos(roll) * x3 - std::sin(roll) * y3;
  const double y1 = std::sin(roll) * x3 + std::cos(roll) * y3;
  const double z2 = -1;
  const double x = std::cos(yaw) * x2 + std::sin(yaw) * z2;
  const double z1 = -std::sin(yaw) * x2 + std::cos(yaw) * z2;
  return {x, std::cos(pitch) * y1 - std::sin(pitch) * z1,
          std::sin(pitch) * y1 + std::cos(pitch) * z1};
}

}  // namespace aucast::sources
