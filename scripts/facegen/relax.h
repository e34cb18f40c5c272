#pragma once

#include "scripts/facegen/layout.h"

namespace aucast::facegen {

/// Stage 3: spreads the free vertices evenly over the sculpt, first inside the pinned borders of
/// the patches, then across them, and draws the base of the neck in under the collar.
void relax(const Identity& who, HalfHead& half);

}  // namespace aucast::facegen
