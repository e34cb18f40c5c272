#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scripts/facegen/identity.h"

namespace aucast::facegen {

// Stage 2: the edge loops of the skin, for the half of the head with x >= 0. A grid of rows (crown
// to neck) and columns (front midline to back midline) whose blocks for eye, mouth, ear and nostril
// are cut out and filled by rings and spokes. The numbering depends on no floating-point result, so
// groups, weights and recordings computed from it stay valid whatever the form is.

enum class Patch : std::uint8_t { Grid, Eye, Mouth, Ear, Nostril, Cap };

/// Rows 0 (ring of the cap) to 48 (base of the neck), columns 0 (front) to 32 (back).
inline constexpr int kRows = 48;
inline constexpr int kColumns = 32;

/// Eye: 32 spokes. Spoke 0 is at the upper inner corner of the block; the next ones are along its
/// top.
inline constexpr int kEyeSpokes = 32;
/// From the inner to the outer corner of the eye, along either lid.
inline constexpr int kLidSteps = kEyeSpokes / 2;
inline constexpr int kInnerCornerSpoke = kEyeSpokes - 4;
/// A spoke counted from the inner corner of the eye (0): along the upper lid to the outer corner
/// (kLidSteps) and back along the lower lid.
[[nodiscard]] constexpr int from_canthus(int spoke) {
  return (spoke - kInnerCornerSpoke + kEyeSpokes) % kEyeSpokes;
}
/// The spoke of such a count.
[[nodiscard]] constexpr int spoke_from_canthus(int k) {
  return (k + kInnerCornerSpoke) % kEyeSpokes;
}
/// The spoke on the other lid that meets this one when the eye shuts; a corner's is its own.
[[nodiscard]] constexpr int opposite_on_lid(int spoke) {
  return spoke_from_canthus(kEyeSpokes - from_canthus(spoke));
}
/// Share of the way from the lid margin (0) to the border of the block (1), ring by ring. 0.22 lies
/// on the fold of the upper lid.
inline constexpr std::array kEyeRings{1.0, 0.84, 0.68, 0.53, 0.41, 0.31, 0.22, 0.13, 0.06};
inline constexpr int kLidMarginRing = 9;  ///< outer edge of the margin
inline constexpr int kLidInnerRing = 10;  ///< inner edge, on the eyeball
inline constexpr int kLidLastRing = 12;   ///< tucked in between lid and eyeball

/// Half of the mouth: 25 spokes. 0 is the middle of the upper lip, 12 the corner, 24 the middle of
/// the lower lip.
inline constexpr int kMouthSpokes = 25;
inline constexpr int kMouthCornerSpoke = 12;
/// Spokes from the middle of a spoke's own lip.
[[nodiscard]] constexpr int from_lip_middle(int spoke) {
  return spoke <= kMouthCornerSpoke ? spoke : kMouthSpokes - 1 - spoke;
}
/// How far along the half mouth a spoke lies, 0 at the middle and 1 at the corner.
[[nodiscard]] inline double along_lip(int spoke) {
  const double u = from_lip_middle(spoke) / double{kMouthCornerSpoke};
  return 1 - power(1 - u, 1.2);
}
/// Share of the way from the red of the lips (0) to the border of the block (1), ring by ring.
inline constexpr std::array kMouthRings{1.0, 0.82, 0.64, 0.46, 0.30, 0.09};
inline constexpr int kLipBorderRing = 6;    ///< where the red begins
inline constexpr int kLipContactRing = 10;  ///< where the lips touch
inline constexpr int kLipLastRing = 13;     ///< inside the mouth; the mouth bag starts there

inline constexpr int kEarSpokes = 32;
inline constexpr int kEarRings = 12;

struct HalfVertex {
  Vec3 position{0};
  Patch patch = Patch::Grid;
  int ring = 0;             ///< of a polar patch, outermost first; 0 for the grid
  int spoke = 0;            ///< of a polar patch
  int row = 0;              ///< of the grid
  int column = 0;           ///< of the grid
  bool pinned = false;      ///< relaxation leaves it where it is
  bool on_midline = false;  ///< x is 0 and the mirror image is the vertex itself
};

/// Counter-clockwise as seen from outside.
using Quad = std::array<std::uint32_t, 4>;

struct HalfHead {
  std::vector<HalfVertex> vertices;
  std::vector<Quad> quads;
};

/// The half head before relaxation: pinned vertices are in their place, the others near theirs.
[[nodiscard]] HalfHead lay_out_half_head(const Identity& who);

}  // namespace aucast::facegen
