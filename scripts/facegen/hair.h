#pragma once

#include "scripts/facegen/identity.h"
#include "scripts/facegen/part.h"

namespace aucast::facegen {

/// Hair: tapering locks with a shade of their own, which break the outline and the hairline, over a
/// shell; a lining shows where one looks under it. All heads have the same number of each.
[[nodiscard]] Part make_hair(const Identity& who);

/// A place on the scalp where hair grows.
struct ScalpPoint {
  Vec3 place{0};
  double inside = 0;  ///< how far behind the hairline: 0 at it, 1 at the crown
};

/// A net of such places over the scalp.
[[nodiscard]] std::vector<ScalpPoint> scalp_of(const Identity& who);

}  // namespace aucast::facegen
