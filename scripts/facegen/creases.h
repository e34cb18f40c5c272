#pragma once

#include <vector>

#include "scripts/facegen/identity.h"
#include "scripts/facegen/skin.h"

namespace aucast::facegen {

/// The lines that expressions draw: one part per muscle group and side, made of ribbons that lie on
/// the skin and move with it. A vertex's alpha says how much it darkens the skin at full strength;
/// its gloss, how much light the bulge beside the line catches. In the player each part is a
/// channel with the part's name; the channel's activation says how strongly the lines show.
[[nodiscard]] std::vector<Part> make_creases(const Identity& who, const Skin& skin);

}  // namespace aucast::facegen
