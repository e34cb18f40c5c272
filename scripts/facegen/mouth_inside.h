#pragma once

#include "scripts/facegen/skin.h"

namespace aucast::facegen {

enum class Jawbone : std::uint8_t { Upper, Lower };

/// Fourteen teeth and their gum.
[[nodiscard]] Part make_teeth(Jawbone jawbone);

[[nodiscard]] Part make_tongue();

/// The inside of the cheeks and the throat: continues the last ring of the lips backwards. Its
/// first ring has the position and the weights of that ring, so that the two stay together.
[[nodiscard]] Part make_mouth_bag(const Skin& skin);

}  // namespace aucast::facegen
