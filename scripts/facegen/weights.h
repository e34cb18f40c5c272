#pragma once

#include "scripts/facegen/skin.h"

namespace aucast::facegen {

// Stage 4: what moves with what. All weights come from the layout (patch, ring, spoke) or from
// smooth fields of the position; nothing is picked by hand.

/// Share of the jaw's turn in the open skin.
[[nodiscard]] double jaw_field(const Vec3& p);

/// Share of the head's turn that the shoulders have.
inline constexpr double kShoulders = 0.13;

/// Share of the head's turn: 1 on the head, fading down the neck to that of the shoulders.
[[nodiscard]] double head_field(const Vec3& p);

/// Sets all maps of a vertex that lies on the face without belonging to the layout, as brows do.
void weigh_by_position(const Identity& who, Vertex& vertex);

/// Sets all maps of the skin.
void weigh_skin(const Identity& who, Skin& skin);

}  // namespace aucast::facegen
