#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/action_unit.h"

namespace aucast::sources {

/// Degrees that 100 % of a head or gaze AU stands for (FORMATS.md in this folder).
inline constexpr double kYawDegrees = 35;
inline constexpr double kPitchDegrees = 22;
inline constexpr double kTiltDegrees = 22;
inline constexpr double kGazeYawDegrees = 28;
inline constexpr double kGazePitchDegrees = 22;
/// Millimetres in one unit of our face's mesh. 100 % of AU 57 or 58 moves the head by one unit.
inline constexpr double kMillimetresPerUnit = 14;
/// Greater distances from the camera are reduced to this.
inline constexpr double kDistanceMmMax = 100'000;
inline constexpr double kRadPerDegree = 0.017453292519943295;

/// The intensity of an AU that a recogniser only calls present: FACS C.
inline constexpr double kPresentIntensity = 0.5;

/// One AU of one row. `native`: `value` is on the source's own scale; otherwise it is an intensity.
struct AuValue {
  std::uint8_t number = 0;
  Side side = Side::Both;
  double value = 0;
  bool native = true;
};

/// How far a head or a pair of eyes is turned, in radians; left is the subject's own.
struct Rotation {
  double left_rad = 0;
  double up_rad = 0;
  double tilt_left_rad = 0;  ///< the top of the head towards the left shoulder; heads only
};

/// The data of one row about one face. Reused from row to row.
struct Observation {
  std::optional<double> seconds;      ///< on the source's clock
  std::optional<double> frame;        ///< number of the picture, if the row has one
  std::optional<std::int64_t> face;   ///< if the format names faces
  double confidence = 1;              ///< [0,1]
  bool tracked = true;                ///< the source says that it saw the face
  std::optional<double> distance_mm;  ///< of the head from the camera
  std::vector<AuValue> aus;           ///< only those with data

  /// Empties the observation but keeps its memory.
  void clear();
  /// Sets `face` from a column of the format; a number beyond 1e9 is no identifier.
  void name_face(std::optional<double> identifier);
  /// Adds AUs 51-56: each direction of the turn with its intensity, the opposite one with 0.
  void add_head(const Rotation& turn);
  /// Adds AUs 61-64 likewise: the eyes' turn within the head, as FACS scores it, not the line of
  /// sight in the room.
  void add_gaze(const Rotation& turn);
};

/// A direction in camera space: x right in the image, y down, z away from the camera.
struct CameraVector {
  double x = 0;
  double y = 0;
  double z = -1;
};

/// The eyes' turn within the head, from the line of sight in camera space: the head's rotation is
/// undone. `pitch`, `yaw` and `roll` are that rotation in radians as OpenFace has them, R = Rx Ry
/// Rz.
[[nodiscard]] Rotation gaze_in_head(const CameraVector& sight, double pitch, double yaw,
                                    double roll);
/// The reverse: the line of sight from the turns of eyes and head.
[[nodiscard]] CameraVector sight_in_room(const Rotation& eyes, double pitch, double yaw,
                                         double roll);

}  // namespace aucast::sources
