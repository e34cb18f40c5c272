#pragma once

#include <span>

#include "scripts/facegen/hair.h"
#include "scripts/facegen/skin.h"

namespace aucast::facegen {

/// Stage 5: colour and gloss of the skin.
void paint_skin(const Identity& who, Skin& skin);

/// Gives the sockets of the eyes back some of the light that the baked occlusion takes from them.
void lighten_sockets(Skin& skin);

/// Darkens the inner side of the lips. Occlusion was baked with the mouth shut, so without this,
/// lights from behind would shine on that side when the mouth opens.
void shade_inner_lips(Skin& skin);

/// Darkens the scalp under the hair, so that no light skin shows between the strands.
void tint_scalp(const Identity& who, Skin& skin, std::span<const ScalpPoint> scalp);

/// Darkens the skin beside hair, and tints it: the light that arrives there came through the hair.
void shade_under_hair(const Identity& who, Skin& skin, const Part& hair);

}  // namespace aucast::facegen
