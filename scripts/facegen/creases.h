#pragma once

#include <vector>

#include "scripts/facegen/identity.h"
#include "scripts/facegen/skin.h"

namespace aucast::facegen {

/// The lines that expressions draw: one part per muscle group and side, made of ribbons that lie on
/// the skin and move with it. Alpha is how much a place darkens at full strength, gloss how much
/// the bulge beside the line catches light. The player shows a part by the channel of its name.
[[nodiscard]] std::vector<Part> make_creases(const Identity& who, const Skin& skin);

}  // namespace aucast::facegen
