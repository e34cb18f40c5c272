#pragma once

#include "scripts/facegen/identity.h"
#include "scripts/facegen/part.h"

namespace aucast::facegen {

/// An eyeball. `side`: 1 left, -1 right. Rings of vertices lie exactly on the edges of pupil, iris
/// and limbus.
[[nodiscard]] Part make_eye(const Identity& who, int side);

}  // namespace aucast::facegen
