#pragma once

#include "client/gui/gui.h"
#include "client/gui/model/gui_commands.h"
#include "client/gui/model/gui_model.h"

namespace aucast::app {

/// What remains to be done for Esc after close_nearest().
struct Escaped {
  gui::GuiCommands commands;
  bool ends_full_screen = false;
};
/// Closes only what is on top. Never leaves the player: only q and the window's close button do
/// that. If it ends full screen, it also closes a notice.
[[nodiscard]] Escaped close_nearest(gui::Gui& gui, const gui::GuiModel& shown, bool full_screen);

}  // namespace aucast::app
