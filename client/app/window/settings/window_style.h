#pragma once

#include <cstdint>
#include <optional>

#include "client/gui/model/gui_model.h"
#include "client/view/style.h"

namespace aucast::app {

/// The plain background (sRGB, 0xRRGGBB) that `ground` means; nullopt: the studio. `studio`: the
/// colour that --background puts in the studio's place.
[[nodiscard]] std::optional<std::uint32_t> plain_ground(gui::Ground ground,
                                                        std::optional<std::uint32_t> studio);

/// How the window draws its face. `background`: 0xRRGGBB in the studio's place, from --background.
/// `scale`: of the screen.
[[nodiscard]] view::Style window_style(const gui::RenderingSettings& settings,
                                       std::optional<std::uint32_t> background, float scale);

}  // namespace aucast::app
