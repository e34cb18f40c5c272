#pragma once

#include "scripts/facegen/skin.h"

namespace aucast::facegen {

// Stage 4: the weights by which muscles, jaw and head move each vertex. They are computed from the
// vertex's place in the layout (patch, ring, spoke) or are smooth functions of its position; no
// weight is set by hand.

/// Share of the jaw's turn at a place of the skin that is not on the lips.
[[nodiscard]] double jaw_field(const Vec3& p);

/// The shoulders' share of the head's turn.
inline constexpr double kShoulders = 0.13;

/// Share of the head's turn: 1 on the head, falling down the neck to kShoulders.
[[nodiscard]] double head_field(const Vec3& p);

/// Sets all maps of a vertex that lies on the face but is not in the layout, such as a vertex of a
/// brow.
void weigh_by_position(const Identity& who, Vertex& vertex);

/// Sets all maps of the skin.
void weigh_skin(const Identity& who, Skin& skin);

}  // namespace aucast::facegen
