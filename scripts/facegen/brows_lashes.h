#pragma once

#include "scripts/facegen/skin.h"

namespace aucast::facegen {

/// A brow: single hairs over a soft ground, all lying on the skin. `side`: 1 left, -1 right. The
/// ground's vertices come first: 41 rows of 7, from the nose to the temple.
[[nodiscard]] Part make_brow(const Identity& who, int side);

/// What moves with the lids: the lashes and the line they stand in, the fold of the upper lid and
/// the shadow of the lids on the eyeball.
[[nodiscard]] Part make_lashes(const Identity& who, const Skin& skin);

}  // namespace aucast::facegen
