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
  CloseNearest,  ///< closes what is open on top, or ends full screen
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

/// What a key does, where possible as in mpv; null: nothing (Key::None).
[[nodiscard]] const KeyMeaning* meaning_of(render::Key key);

}  // namespace aucast::app
