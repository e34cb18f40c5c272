#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "common/mesh/landmarks.h"

namespace aucast::mesh {

/// How a head is turned in the picture, in radians by the subject's own left.
struct HeadTurn {
  double left_rad = 0;
  double up_rad = 0;
  double tilt_left_rad = 0;  ///< the top of the head towards the left shoulder
};

/// Landmarks that no expression moves: corners of the eyes, bridge of the nose, temples.
inline constexpr std::array<std::size_t, 14> kStillLandmarks{33,  133, 362, 263, 168, 6,   197,
                                                             195, 5,   4,   127, 356, 234, 454};
using StillPoints = std::array<Point, kStillLandmarks.size()>;

/// Where they are on a typical face from the front, with the outer corners of the eyes 1 apart.
inline constexpr StillPoints kTypicalStillPoints{{{-0.5000, 0.0000, 0.0000},
                                                  {-0.2088, 0.0089, -0.0657},
                                                  {0.2088, 0.0089, -0.0657},
                                                  {0.5000, 0.0000, 0.0000},
                                                  {0.0000, -0.0683, -0.2320},
                                                  {0.0000, 0.0215, -0.2941},
                                                  {0.0000, 0.1052, -0.3535},
                                                  {0.0000, 0.1805, -0.4050},
                                                  {0.0000, 0.2585, -0.4577},
                                                  {0.0000, 0.3517, -0.4963},
                                                  {-0.8708, 0.0336, 0.5824},
                                                  {0.8708, 0.0336, 0.5824},
                                                  {-0.8619, 0.2239, 0.6308},
                                                  {0.8619, 0.2239, 0.6308}}};

/// A face laid on another one so that the still landmarks of both fit best.
struct FittedHead {
  std::array<Point, kLandmarks> points{};  ///< in the other one's places and unit
  HeadTurn turn;                           ///< against the other one
  double scale = 1;  ///< how much larger than the other one it is in the picture
};

/// The similarity of least squares (Horn 1987, "Closed-form solution of absolute orientation using
/// unit quaternions").
[[nodiscard]] FittedHead fit_head(const Landmarks& landmarks, const StillPoints& onto);

}  // namespace aucast::mesh
