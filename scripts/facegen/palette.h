#pragma once

#include "scripts/facegen/maths.h"

namespace aucast::facegen {

// Linear RGB.

/// The colours in which one person differs from another.
struct Palette {
  Vec3 skin{0.750, 0.515, 0.408};
  Vec3 flush{0.745, 0.365, 0.315};
  Vec3 forehead_skin{0.76, 0.555, 0.450};
  Vec3 neck_skin{0.68, 0.465, 0.385};
  Vec3 lid_skin{0.60, 0.35, 0.29};
  Vec3 lid_rim{0.50, 0.24, 0.21};
  Vec3 lip{0.66, 0.285, 0.265};
  Vec3 brow{0.095, 0.055, 0.034};
  Vec3 hair{0.16, 0.09, 0.055};
  Vec3 hair_light{0.36, 0.21, 0.12};
  Vec3 iris_inner{0.46, 0.42, 0.24};
  Vec3 iris_outer{0.23, 0.33, 0.30};
  Vec3 cloth{0.13, 0.17, 0.23};
  Vec3 collar{0.10, 0.135, 0.185};
  double beard = 0;    ///< how much of a shaven beard shows
  double mottled = 0;  ///< how unevenly its red is spread, from 0, even, to 1
};

// Colours that are the same for everybody.

/// A factor on the skin's colour where a beard was shaven: as hair shines through, a little bluish.
inline constexpr Vec3 kBeardShade{0.44, 0.52, 0.60};
/// A factor on the skin's colour under hair or right beside it.
inline constexpr Vec3 kUnderHair{0.66, 0.57, 0.53};
inline constexpr Vec3 kLidInside{0.62, 0.30, 0.28};
inline constexpr Vec3 kCaruncle{0.66, 0.34, 0.30};
inline constexpr Vec3 kLipInside{0.42, 0.13, 0.12};
/// A factor on the ends of the lips.
inline constexpr Vec3 kLipWeb{0.62, 0.45, 0.42};
inline constexpr Vec3 kNostril{0.15, 0.048, 0.036};
inline constexpr Vec3 kNostrilRim{0.35, 0.14, 0.11};
inline constexpr Vec3 kMouthFront{0.56, 0.165, 0.145};
inline constexpr Vec3 kMouthBack{0.36, 0.082, 0.066};
inline constexpr Vec3 kGum{0.60, 0.27, 0.25};
inline constexpr Vec3 kGumBack{0.26, 0.12, 0.105};
inline constexpr Vec3 kToothNeck{0.83, 0.74, 0.60};
inline constexpr Vec3 kTooth{0.97, 0.92, 0.83};
inline constexpr Vec3 kTongue{0.61, 0.235, 0.215};
inline constexpr Vec3 kLash{0.045, 0.028, 0.022};
inline constexpr Vec3 kPupil{0.012, 0.011, 0.012};
inline constexpr Vec3 kIrisEdge{0.03, 0.035, 0.035};
inline constexpr Vec3 kLimbus{0.20, 0.20, 0.19};
inline constexpr Vec3 kSclera{0.66, 0.60, 0.565};
inline constexpr Vec3 kScleraCorner{0.50, 0.325, 0.29};
/// A factor on the light in the deepest line.
inline constexpr Vec3 kCrease{0.57, 0.43, 0.38};
inline constexpr Vec3 kForeheadCrease{0.61, 0.42, 0.36};

}  // namespace aucast::facegen
