#include "client/app/window/window_style.h"

#include "client/app/film/shot.h"

namespace aucast::app {

std::optional<std::uint32_t> plain_ground(gui::Ground ground, std::optional<std::uint32_t> studio) {
  switch (ground) {
    case gui::Ground::Studio:
    case gui::Ground::None:
      break;
    case gui::Ground::Black:
      return 0x000000;
    case gui::Ground::Grey:
      return 0x737373;
    case gui::Ground::White:
      return 0xFFFFFF;
  }
  return studio;
}

view::Style window_style(const gui::RenderingSettings& settings,
                         std::optional<std::uint32_t> background, float scale) {
  return {.background = backdrop(plain_ground(settings.ground, background),
                                 settings.ground == gui::Ground::None),
          .layers = settings.layers,
          .light = view::key_light(static_cast<float>(settings.light_yaw_deg),
                                   static_cast<float>(settings.light_pitch_deg),
                                   static_cast<float>(settings.light_percent) / 100),
          .scale = scale};
}

}  // namespace aucast::app
