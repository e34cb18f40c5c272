#pragma once

#include <cstdint>
#include <optional>

#include "client/gui/gui_model.h"
#include "client/view/style.h"

namespace aucast::app {

/// The plain ground that these settings mean, sRGB; nothing: the studio. `studio`: what
/// --background put in its place.
[[nodiscard]] std::optional<std::uint32_t> plain_ground(gui::Ground ground,
                                                        std::optional<std::uint32_t> studio);

/// How the window draws its face. `background`: 0xRRGGBB instead of the studio's, as --background
/// says; `scale` of the screen.
[[nodiscard]] view::Style window_style(const gui::RenderingSettings& settings,
                                       std::optional<std::uint32_t> background, float scale);

}  // namespace aucast::app
