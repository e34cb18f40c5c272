#pragma once

#include <span>

#include "scripts/facegen/hair.h"
#include "scripts/facegen/skin.h"

namespace aucast::facegen {

/// Stage 5: colour and gloss of the skin.
void paint_skin(const Identity& who, Skin& skin);

/// Gives the sockets of the eyes some of the light that the baked occlusion takes.
void lighten_sockets(Skin& skin);

/// Takes light from the inner side of the lips, which the baked occlusion sees with the mouth shut
/// and the lights from behind would draw when it opens.
void shade_inner_lips(Skin& skin);

/// Darkens the scalp under the hair, so that no light skin shows between the strands.
void tint_scalp(const Identity& who, Skin& skin, std::span<const ScalpPoint> scalp);

/// Skin beside hair gets less light, and what arrives came past the hair.
void shade_under_hair(const Identity& who, Skin& skin, const Part& hair);

}  // namespace aucast::facegen
