#pragma once

#include <cstdint>
#include <variant>

#include "client/app/window/window_session.h"
#include "client/gui/model/gui_commands.h"
#include "client/render/window.h"

namespace aucast::app {

/// What a key does to the window itself.
enum class WindowAct : std::uint8_t {
  Leave,
  CloseNearest,  ///< closes the topmost thing that is open, or ends full screen
  ToggleFullScreen,
  ToggleBare,
  TogglePanel,
  ToggleKeys
};
/// What a key does in the session whose face is shown.
using SessionAct = void (WindowSession::*)(Instant now);
struct ChangeVolume {
  int percent = 0;  ///< by how much; below 0: quieter
};
using KeyMeaning = std::variant<gui::GuiCommand, WindowAct, SessionAct, ChangeVolume>;

/// Returns what a key does; where possible, that is what it does in mpv. Returns null for a key
/// that does nothing (Key::None).
[[nodiscard]] const KeyMeaning* meaning_of(render::Key key);

}  // namespace aucast::app
