#pragma once

#include <cstddef>
#include <functional>

#include "scripts/facegen/identity.h"
#include "scripts/facegen/part.h"

namespace aucast::facegen {

// What haircuts are made of: smooth sheets, whose strands are the renderer's (map `strand`). All
// heads have as many of each and in this order, so that their meshes have one topology; edges blend
// in this order too: what is nearer to the eye comes later.

struct SheetSize {
  std::size_t columns = 0;
  std::size_t rows = 0;
};
inline constexpr SheetSize kUnderSheet{65, 29};
inline constexpr SheetSize kOuterSheet{161, 41};
inline constexpr SheetSize kLock{6, 17};
inline constexpr std::size_t kLocks = 16;

struct HairPoint {
  Vec3 place{0};
  Vec3 colour{0};
  double alpha = 1;   ///< below 1: that share of the strands is left
  double strand = 0;  ///< which strand runs here, [0,1]
  double gloss = 1;
};

/// Adds a sheet of which `at(u, v)`, both in [0, 1], are the points: u to the right as seen from
/// outside when v runs down.
void add_sheet(Part& hair, const SheetSize& size,
               const std::function<HairPoint(double, double)>& at);

/// Between the colours of the hair: 0 the dark one, 1 the light one.
[[nodiscard]] Vec3 shade_of(const Identity& who, double light);

/// Hair that falls along the haircut's guides.
[[nodiscard]] Part make_long_hair(const Identity& who);
/// Hair that lies on the scalp, from the crown to the hairline.
[[nodiscard]] Part make_short_hair(const Identity& who);

}  // namespace aucast::facegen
