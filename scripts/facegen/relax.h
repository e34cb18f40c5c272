#pragma once

#include "scripts/facegen/layout.h"

namespace aucast::facegen {

/// Stage 3: spreads the free vertices evenly over the sculpt, first with the borders of the patches
/// pinned, then with most of them free. Then moves the base of the neck inwards, under the collar.
void relax(const Identity& who, HalfHead& half);

}  // namespace aucast::facegen
