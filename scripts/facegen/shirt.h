#pragma once

#include "scripts/facegen/identity.h"
#include "scripts/facegen/part.h"

namespace aucast::facegen {

/// A shirt with a rolled collar, which hides where the neck ends. It does not move.
[[nodiscard]] Part make_shirt(const Identity& who);

}  // namespace aucast::facegen
