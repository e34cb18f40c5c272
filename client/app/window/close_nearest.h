#pragma once

#include "client/gui/gui.h"
#include "client/gui/model/gui_commands.h"
#include "client/gui/model/gui_model.h"

namespace aucast::app {

/// What the caller must still do for Esc after close_nearest().
struct Escaped {
  gui::GuiCommands commands;
  bool ends_full_screen = false;
};
/// Closes only the topmost thing that is open. Never leaves the player: only q and the window's
/// close button do that. In full screen, closes notices together with the thing below them.
[[nodiscard]] Escaped close_nearest(gui::Gui& gui, const gui::GuiModel& shown, bool full_screen);

}  // namespace aucast::app
