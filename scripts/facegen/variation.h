#pragma once

#include <cstdint>

#include "scripts/facegen/identity.h"

namespace aucast::facegen {

/// Somebody who looks a little like `who`: measures of the form are moved some of the way towards
/// those of `other`, or away from them, and the skin is made lighter or darker. Programs that read
/// faces are trained with such people, lest they learn a few faces by heart. The same number gives
/// the same person; 0 gives `who`.
[[nodiscard]] Identity varied(const Identity& who, const Identity& other, std::uint32_t number);

}  // namespace aucast::facegen
