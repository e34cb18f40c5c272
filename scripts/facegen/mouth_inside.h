#pragma once

#include "scripts/facegen/skin.h"

namespace aucast::facegen {

enum class Jawbone : std::uint8_t { Upper, Lower };

/// The fourteen teeth of one jawbone and their gum.
[[nodiscard]] Part make_teeth(Jawbone jawbone);

[[nodiscard]] Part make_tongue();

/// The inside of the cheeks and the throat, which continue the lips backwards. The first ring has
/// the positions and weights of the last ring of the lips, so that the two stay together.
[[nodiscard]] Part make_mouth_bag(const Skin& skin);

}  // namespace aucast::facegen
