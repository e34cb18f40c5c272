#pragma once

#include <cstdint>
#include <variant>

#include "client/app/window/window_session.h"
#include "client/gui/gui_commands.h"
#include "client/render/window.h"

namespace aucast::app {

/// What a key does to the window itself.
enum class WindowAct : std::uint8_t {
  Leave,
  CloseNearest,  ///< what is open on top, or full screen
  ToggleFullScreen,
  ToggleBare,
  TogglePanel,
  ToggleKeys
};
/// What a key does to whichever face is shown.
using SessionAct = void (WindowSession::*)(Instant now);
struct ChangeVolume {
  int percent = 0;  ///< more; below 0: less
};
using KeyMeaning = std::variant<gui::GuiCommand, WindowAct, SessionAct, ChangeVolume>;

/// What a key is for, where possible as in mpv; null for Key::None.
[[nodiscard]] const KeyMeaning* meaning_of(render::Key key);

}  // namespace aucast::app
