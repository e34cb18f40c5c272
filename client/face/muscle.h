#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <variant>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace aucast::face {

/// Files give angles in degrees.
inline constexpr float kRadPerDeg = std::numbers::pi_v<float> / 180.0F;

/// The largest activation of a muscle that says nothing else.
inline constexpr float kMuscleMax = 2;

// Muscles after Waters 1987 in the clean forms of thesis chapter 4. Lengths are mesh units.
// The displacement is the shift P' - P of point P of the neutral face at activation a (0..2;
// classic folders 0..4). It is zero outside the zone of influence and linear in a (for a
// LinearMuscle, up to its cap).

/// Pulls the skin inside a cone towards the attachment. P' = P - (P - v1) min(a G, cap) A r with
/// G = sec(zone) - 1, A = (cos th - cos zone) / (1 - cos zone), r = 1 up to falloff_start and
/// cos(90 deg (D - Rs) / (Rf - Rs)) from there, where D = |P - v1| and th is the angle at v1
/// between P and v2 (Waters' released program; thesis eq. 3.1-3.4, read so that the displacement is
/// continuous).
struct LinearMuscle {
  glm::vec3 attachment{0};   ///< v1, the fixed end on bone
  glm::vec3 insertion{0};    ///< v2, the end in the skin; must differ from the attachment
  float zone_rad = 0.6F;     ///< half angle of the cone, in (0, pi/2)
  float falloff_start = 0;   ///< Rs >= 0
  float falloff_finish = 1;  ///< Rf > Rs
  /// Largest fraction of the way to v1: 0.95 keeps our faces free of folds; nullopt: uncapped, as
  /// in Waters' program.
  std::optional<float> cap = 0.95F;
};

/// Draws the mouth together in its plane and pushes it forward. With x and y counted from the
/// centre, rho = sqrt(x^2 + y^2), f = 1 - sqrt((x/lx)^2 + (y/ly)^2), g2 = (rho - ly) / (lx - ly) or
/// 0 where rho < ly, a point with f > 0 moves by a (lx/2) f g2 towards the centre and by
/// a f (1 - rho/lx) / protrusion forward (thesis eq. 3.5-3.9, clean form).
struct MouthSphincter {
  glm::vec3 centre{0};
  glm::vec2 semi_axes{2, 1};  ///< lx >= ly > 0
  float depth = 3;            ///< only points with |z - cz| < depth move; fades over the last
                              ///< quarter
  float protrusion = 10;      ///< Z of eq. 3.9, a divisor: larger means less forward
};

/// Draws the skin round the lids towards the eye's horizontal axis: y' = y (1 - (a/2) share f) and
/// z' = z + a f (1 - |y|/ly) / bulge where f > 0, with x, y and f as for the mouth and share =
/// upper_share above the axis, lower_share below (thesis eq. 3.10-3.13, clean form).
struct EyeSphincter {
  glm::vec3 centre{0};
  glm::vec2 semi_axes{2, 1};
  float depth = 3;           ///< as for the mouth
  float bulge = 30;          ///< Z of the thesis, a divisor: larger means less forward
  float upper_share = 0.3F;  ///< how strongly skin above the axis moves towards it
  float lower_share = 0.7F;  ///< the same below it; AU 6 and 7 lift the lower lid more
};

/// A broad parallel muscle such as the frontalis (thesis eq. 3.14-3.19, clean form): the strip of
/// width `width` from the attachment line to the insertion line moves towards the attachment. The
/// shift is largest at `peak` of the way and fades to both sides. The strip faces the viewer.
struct SheetMuscle {
  glm::vec3 attachment{0};  ///< Ac, middle of the line on bone
  glm::vec3 insertion{0};   ///< Ic, middle of the line in the skin
  float width = 2;
  float peak = 0.7F;  ///< L / |Ic - Ac| in (0, 1)
  float depth = 3;    ///< distance from the sheet's plane up to which points move; fades as for the
                      ///< mouth
};

/// A pull for muscles that FACS needs and whose geometry the thesis does not give (mentalis,
/// depressor labii, ...): `direction` is the displacement at the centre for activation 1, falling
/// off as a Gaussian of the given radii and ending at three times the radii. Folds nothing up to
/// activation 2 while |direction / radii| < 0.58.
struct LocalPull {
  glm::vec3 centre{0};
  glm::vec3 direction{0};
  glm::vec3 radii{1};  ///< distance along each axis at which exp(-1) of the pull is left
};

using MuscleShape =
    std::variant<LinearMuscle, MouthSphincter, EyeSphincter, SheetMuscle, LocalPull>;

/// A muscle of a face, such as left_zygomaticus_major.
struct Muscle {
  std::string name;
  MuscleShape shape;
  std::string mask;  ///< name of the map of the mesh that multiplies the displacement; empty: none
  bool mask_alone = false;  ///< `mask` is used in place of the map "muscle", not beside it, so that
                            ///< tongue and teeth can move
  /// True: its activation is multiplied by 1 - lid_close^2 of its side, because a lower lid that
  /// stayed raised would run into the closing upper lid.
  bool yields_to_lids = false;
  float activation_max = kMuscleMax;  ///< its channel's
};

/// The displacement per unit of activation, and the activation from which the displacement stays
/// the same (infinite without a cap): at activation a >= 0 the displacement is
/// per_unit * min(a, activation_cap). Masks are not applied.
struct LinearInfluence {
  glm::vec3 per_unit{0};
  float activation_cap = 0;
};
[[nodiscard]] LinearInfluence influence(const MuscleShape& shape, const glm::vec3& point);

}  // namespace aucast::face
