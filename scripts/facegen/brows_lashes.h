#pragma once

#include "scripts/facegen/skin.h"

namespace aucast::facegen {

/// A brow: a strip with a lens-shaped section along the brow's spine that fades at all edges. Side
/// 1 left, -1 right.
[[nodiscard]] Part make_brow(const Identity& who, int side);

/// The lashes of all four lids: ribbons that grow from the lid margin and move with it.
[[nodiscard]] Part make_lashes(const Skin& skin);

}  // namespace aucast::facegen
