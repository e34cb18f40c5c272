#include "client/app/window/settings/window_style.h"

#include "client/app/video/shot.h"

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

namespace {

/// The chequer by which programs show transparency.
view::Background chequer(float scale) {
  constexpr std::uint32_t kLight = 0x9A9A9A;
  constexpr std::uint32_t kDark = 0x7A7A7A;
  constexpr float kSquare = 12;
  return {backdrop(kLight).centre, backdrop(kDark).centre, true, kSquare * scale};
}

}  // namespace

view::Style window_style(const gui::RenderingSettings& settings,
                         std::optional<std::uint32_t> background, float scale) {
  return {.background = settings.ground == gui::Ground::None
                            ? chequer(scale)
                            : backdrop(plain_ground(settings.ground, background)),
          .layers = settings.layers,
          .light = view::key_light(static_cast<float>(settings.light_yaw_deg),
                                   static_cast<float>(settings.light_pitch_deg),
                                   static_cast<float>(settings.light_percent) / 100),
          .scale = scale};
}

}  // namespace aucast::app
