#pragma once

#include <array>

#include "scripts/facegen/identity.h"

namespace aucast::facegen {

// Measures that several stages share. Units and axes: data/faces/README.md (1 unit = 1.4 cm, y
// up, z to the viewer); the head is described for x >= 0, the subject's left, and mirrored.

/// Larger than life (an eyeball measures 0.86), so that the corners of the eye lie on the ball and
/// no caruncle has to be modelled.
inline constexpr double kEyeRadius = 1.32;
/// The centre of the left eyeball. face.toml must have the same one, for the player.
[[nodiscard]] Vec3 eye_centre(const Form& form);

/// The iris spans a little over two fifths of the lids' opening; a larger one looks like a doll's.
inline constexpr double kIrisRadius = 0.485;

/// Corners of the eye relative to its centre: towards the nose and towards the temple.
inline constexpr double kInnerCanthus = -1.12;
inline constexpr double kOuterCanthus = 1.26;

/// Height of the lid margins relative to the eye's centre at `dx` beside it.
[[nodiscard]] double upper_lid(const Identity& who, double dx);
[[nodiscard]] double lower_lid(const Identity& who, double dx);
/// Likewise, the height of the fold of the upper lid.
[[nodiscard]] double lid_fold(const Identity& who, double dx);

/// The hollow that brow, temple and nose bound, and the middle of the block of loops in it. They
/// are the same for everybody and do not follow `Form::eye_apart`, for their bounds do not either;
/// an eyeball lies in it a little nearer to the nose or to the temple.
inline constexpr Vec3 kOrbit{2.25, 2.92, 8.15};
inline constexpr glm::dvec2 kEyeBlockMiddle{kOrbit.x, 2.75};

/// What the jaw turns about. face.toml must have the same one, for the player.
inline constexpr Vec3 kJawHinge{0, 0.9, 1.5};

/// Where the muscle that draws a smile is fixed to the cheekbone; muscles.toml has the same one.
inline constexpr Vec3 kSmileAttachment{3.805, 0.868, 6.6};

/// The rope of the neck, a muscle: from behind the ear to the pit of the throat.
struct NeckRope {
  Vec3 behind_ear{0};
  Vec3 pit{0};
};
[[nodiscard]] NeckRope neck_rope(const Form& form);

/// x of the corner of the mouth.
inline constexpr double kMouthCorner = 1.70;

/// Height of the line where the lips touch, and of the borders of the red of the lips, at x >= 0.
[[nodiscard]] double lip_contact(const Identity& who, double x);
[[nodiscard]] double upper_lip_border(const Identity& who, double x);
[[nodiscard]] double lower_lip_border(const Identity& who, double x);

/// The groove from nose to lip: heights of its ends, and x of the ridge beside it.
inline constexpr double kPhiltrumTop = -0.75;
inline constexpr double kPhiltrumFoot = -2.0;
inline constexpr double kPhiltrumRidge = 0.36;

/// The furrow from the wing of the nose past the corner of the mouth: points of x, y and depth, 1
/// at its deepest. `Form::furrow` engraves it, as years do; smiles deepen it.
inline constexpr std::array<Vec3, 5> kFurrow{{{1.14, -0.26, 0.3},
                                              {1.50, -0.76, 0.75},
                                              {2.01, -1.36, 1.0},
                                              {2.43, -2.05, 0.6},
                                              {2.62, -2.75, 0.0}}};

/// The spine of the brow in the front plane (z = 0) from t = 0 at the nose to 1 at the temple, and
/// half of its width there.
[[nodiscard]] Vec3 brow_spine(const Identity& who, double t);
[[nodiscard]] double brow_half_width(const Identity& who, double t);

}  // namespace aucast::facegen
