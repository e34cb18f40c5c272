#pragma once

#include <cstddef>
#include <functional>

#include "scripts/facegen/identity.h"
#include "scripts/facegen/part.h"

namespace aucast::facegen {

// What haircuts are made of: smooth sheets, on which the renderer draws strands (map `strand`). All
// heads have the same number of each kind of sheet in the same order, so their meshes have one
// topology. A sheet nearer to the viewer comes later in that order, so that its edges blend over
// the rest.

struct SheetSize {
  std::size_t columns = 0;
  std::size_t rows = 0;
};
inline constexpr SheetSize kUnderSheet{65, 29};
inline constexpr SheetSize kOuterSheet{161, 41};
inline constexpr SheetSize kLock{6, 17};
inline constexpr SheetSize kStray{2, 6};
inline constexpr SheetSize kWisp{2, 4};
inline constexpr std::size_t kStrays = 56;
inline constexpr std::size_t kWisps = 100;

struct HairPoint {
  Vec3 place{0};
  Vec3 colour{0};
  double alpha = 1;   ///< the share of the strands that is drawn
  double strand = 0;  ///< which strand runs here, [0,1]
  double gloss = 1;
};

/// Adds a sheet with the points `at(u, v)`, u and v in [0, 1]. Seen from outside, with v running
/// down, u runs to the right.
void add_sheet(Part& hair, const SheetSize& size,
               const std::function<HairPoint(double, double)>& at);

/// Adds a single hair that stands off the rest, numbered `number`: `at(v)` is its place from root
/// (0) to tip (1), `up(v)` the direction away from the head.
void add_stray(Part& hair, const Identity& who, std::size_t number,
               const std::function<Vec3(double)>& at, const std::function<Vec3(double)>& up);

/// Adds a fine hair that lies over skin beside the rest, in the colour `light` (`shade_of`).
void add_wisp(Part& hair, const Identity& who, double light, const std::function<Vec3(double)>& at,
              const std::function<Vec3(double)>& up);

/// A mixture of the two colours of the hair; `light`: 0 the dark one, 1 the light one.
[[nodiscard]] Vec3 shade_of(const Identity& who, double light);

/// Hair that falls along the haircut's guides.
[[nodiscard]] Part make_long_hair(const Identity& who);
/// Hair that lies on the scalp, from the crown to the hairline.
[[nodiscard]] Part make_short_hair(const Identity& who);

}  // namespace aucast::facegen
