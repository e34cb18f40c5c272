#pragma once

#include "client/gui/gui.h"
#include "client/gui/gui_commands.h"
#include "client/gui/gui_model.h"

namespace aucast::app {

/// What Esc does besides what close_nearest() did.
struct Escaped {
  gui::GuiCommands commands;
  bool ends_full_screen = false;
};
/// Closes one thing, the nearest to the user; only q and the window's cross leave. Whoever ends
/// full screen does not wait for a sentence to go, nor is it left behind.
[[nodiscard]] Escaped close_nearest(gui::Gui& gui, const gui::GuiModel& shown, bool full_screen);

}  // namespace aucast::app
