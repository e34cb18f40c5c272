#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "common/mesh/landmarks.h"

namespace aucast::mesh {

/// How far a head is turned in the picture, in radians; left is the subject's own.
struct HeadTurn {
  double left_rad = 0;
  double up_rad = 0;
  double tilt_left_rad = 0;  ///< the top of the head towards the left shoulder
};

/// The landmarks that no expression moves: corners of the eyes, bridge of the nose, temples.
inline constexpr std::array<std::size_t, 14> kStillLandmarks{33,  133, 362, 263, 168, 6,   197,
                                                             195, 5,   4,   127, 356, 234, 454};
using StillPoints = std::array<Point, kStillLandmarks.size()>;

/// Where the still landmarks are on a typical face seen from the front, in units of the distance
/// between the outer corners of the eyes.
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

/// A face moved, turned and scaled onto another one so that their still landmarks fit best.
struct FittedHead {
  std::array<Point, kLandmarks> points{};  ///< in the other face's coordinates and unit
  HeadTurn turn;                           ///< relative to the other face
  double scale = 1;  ///< how many times larger this face was than the other one
};

/// Fits by least squares (Horn 1987, "Closed-form solution of absolute orientation using unit
/// quaternions").
[[nodiscard]] FittedHead fit_head(const Landmarks& landmarks, const StillPoints& onto);

}  // namespace aucast::mesh
