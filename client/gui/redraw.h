#pragma once

#include "client/gui/gui_model.h"

namespace aucast::gui {

/// ImGui needs some frames after a change until everything is where it belongs.
inline constexpr int kFramesAfterChange = 3;

/// How many frames to draw because the panels, drawn from `shown`, should show `now`: none, a
/// single one when only time went on (a stream's place, the plots), kFramesAfterChange otherwise.
/// The place of a stream alone is shown anew only every tenth of a second.
[[nodiscard]] int frames_due(const GuiModel& shown, GuiModel now);

}  // namespace aucast::gui
