#pragma once

#include "scripts/facegen/maths.h"

namespace aucast::facegen {

// Linear RGB.
inline constexpr Vec3 kSkin{0.74, 0.505, 0.385};
inline constexpr Vec3 kFlush{0.74, 0.36, 0.29};
inline constexpr Vec3 kForeheadSkin{0.77, 0.55, 0.41};
inline constexpr Vec3 kNeckSkin{0.68, 0.45, 0.35};
inline constexpr Vec3 kLidSkin{0.60, 0.35, 0.29};
inline constexpr Vec3 kLidRim{0.50, 0.24, 0.21};
inline constexpr Vec3 kLidInside{0.62, 0.30, 0.28};
inline constexpr Vec3 kCaruncle{0.78, 0.38, 0.35};
inline constexpr Vec3 kLip{0.66, 0.285, 0.265};
inline constexpr Vec3 kLipInside{0.42, 0.13, 0.12};
inline constexpr Vec3 kNostril{0.20, 0.06, 0.045};
inline constexpr Vec3 kNostrilRim{0.35, 0.14, 0.11};
inline constexpr Vec3 kMouthFront{0.36, 0.105, 0.095};
inline constexpr Vec3 kMouthBack{0.06, 0.015, 0.014};
inline constexpr Vec3 kGum{0.60, 0.27, 0.25};
inline constexpr Vec3 kGumBack{0.35, 0.20, 0.17};
inline constexpr Vec3 kToothNeck{0.84, 0.79, 0.70};
inline constexpr Vec3 kTooth{0.90, 0.87, 0.81};
inline constexpr Vec3 kTongue{0.62, 0.27, 0.26};
inline constexpr Vec3 kBrow{0.095, 0.055, 0.034};
inline constexpr Vec3 kLash{0.045, 0.028, 0.022};
inline constexpr Vec3 kHair{0.16, 0.09, 0.055};
inline constexpr Vec3 kHairLight{0.36, 0.21, 0.12};
inline constexpr Vec3 kPupil{0.012, 0.011, 0.012};
inline constexpr Vec3 kIrisInner{0.46, 0.42, 0.24};
inline constexpr Vec3 kIrisOuter{0.23, 0.33, 0.30};
inline constexpr Vec3 kIrisEdge{0.03, 0.035, 0.035};
inline constexpr Vec3 kLimbus{0.20, 0.20, 0.19};
inline constexpr Vec3 kSclera{0.83, 0.80, 0.775};
inline constexpr Vec3 kScleraCorner{0.80, 0.60, 0.55};
/// What is left of the light in the deepest line.
inline constexpr Vec3 kCrease{0.52, 0.36, 0.31};
inline constexpr Vec3 kCloth{0.13, 0.17, 0.23};
inline constexpr Vec3 kCollar{0.10, 0.135, 0.185};

}  // namespace aucast::facegen
