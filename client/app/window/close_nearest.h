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
/// close button do that. In full screen notices do not count as such a thing: they are closed
/// together with what is open below them, and full screen ends if nothing is.
[[nodiscard]] Escaped close_nearest(gui::Gui& gui, const gui::GuiModel& shown, bool full_screen);

}  // namespace aucast::app
