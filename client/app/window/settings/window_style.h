#pragma once

#include <cstdint>
#include <optional>

#include "client/gui/model/gui_model.h"
#include "client/view/style.h"

namespace aucast::app {

/// The colour (sRGB, 0xRRGGBB) of the plain background for `ground`; nullopt: the background is not
/// plain. `studio`: the colour of --background, which replaces the studio; nullopt: none was given.
[[nodiscard]] std::optional<std::uint32_t> plain_ground(gui::Ground ground,
                                                        std::optional<std::uint32_t> studio);

/// How the window draws its face. `background`: as `studio` of plain_ground(). `scale`: of the
/// screen.
[[nodiscard]] view::Style window_style(const gui::RenderingSettings& settings,
                                       std::optional<std::uint32_t> background, float scale);

}  // namespace aucast::app
