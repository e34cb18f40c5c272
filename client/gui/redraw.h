#pragma once

#include "client/gui/gui_model.h"

namespace aucast::gui {

/// ImGui needs some frames after a change until everything is where it belongs.
inline constexpr int kFramesAfterChange = 3;

/// How many frames to draw because the panels, drawn from `shown`, should show `now`: none, a
/// single one when only time went on (a stream's place, the plots), kFramesAfterChange otherwise.
/// Where it stands is shown in tenths of a second, unless the face moves as well.
[[nodiscard]] int frames_due(const GuiModel& shown, GuiModel now);

}  // namespace aucast::gui
