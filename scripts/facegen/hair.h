#pragma once

#include "scripts/facegen/identity.h"
#include "scripts/facegen/part.h"

namespace aucast::facegen {

/// Hair: smooth sheets, on which the renderer draws the strands. All heads have as many of each.
[[nodiscard]] Part make_hair(const Identity& who);

/// A place on the scalp where hair grows.
struct ScalpPoint {
  Vec3 place{0};
  double inside = 0;  ///< how far behind the hairline
};

/// A net of such places over the scalp.
[[nodiscard]] std::vector<ScalpPoint> scalp_of(const Identity& who);

}  // namespace aucast::facegen
