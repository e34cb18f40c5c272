#pragma once

#include <cstdint>
#include <optional>

#include "client/face/face.h"
#include "client/view/scene.h"
#include "client/view/viewpoint.h"

namespace aucast::app {

/// The viewpoint of --camera.
[[nodiscard]] view::Viewpoint viewpoint_of(view::ViewpointPreset preset, const face::Face& face);

/// The plain background of --background (sRGB, 0xRRGGBB); nullopt: the default one, the studio.
[[nodiscard]] view::Background backdrop(std::optional<std::uint32_t> rgb, bool transparent = false);

}  // namespace aucast::app
