#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "client/face/face.h"
#include "client/view/scene.h"

namespace aucast::app {

/// The viewpoint of --camera: front, three-quarter or profile.
[[nodiscard]] view::Viewpoint viewpoint_preset(std::string_view name, const face::Face& face);

/// The plain background of --background (sRGB, 0xRRGGBB); nullopt: the default one, the studio.
[[nodiscard]] view::Background backdrop(std::optional<std::uint32_t> rgb, bool transparent = false);

}  // namespace aucast::app
