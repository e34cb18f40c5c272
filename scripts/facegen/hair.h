#pragma once

#include "scripts/facegen/identity.h"
#include "scripts/facegen/part.h"

namespace aucast::facegen {

inline constexpr std::size_t kHairStrands = 288;   ///< flow lines round the head
inline constexpr std::size_t kHairRowLength = 33;  ///< vertices along a flow line

/// A short haircut with a side parting: a shell of flow lines from the hairline to the crown.
[[nodiscard]] Part make_hair(const Identity& who);

}  // namespace aucast::facegen
