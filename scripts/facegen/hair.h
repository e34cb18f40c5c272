#pragma once

#include "scripts/facegen/identity.h"
#include "scripts/facegen/part.h"

namespace aucast::facegen {

/// Hair: smooth sheets, on which the renderer draws the strands. The sheets of all heads have the
/// same topology.
[[nodiscard]] Part make_hair(const Identity& who);

/// A place on the scalp where hair grows.
struct ScalpPoint {
  Vec3 place{0};
  double inside = 0;  ///< distance from the hairline, mesh units
};

/// Such places all over the scalp, as a grid.
[[nodiscard]] std::vector<ScalpPoint> scalp_of(const Identity& who);

}  // namespace aucast::facegen
