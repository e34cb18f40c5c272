#pragma once

#include "client/gui/model/gui_model.h"

namespace aucast::gui {

/// How many frames ImGui needs after a change until everything is in its place.
inline constexpr int kFramesAfterChange = 3;

/// How many frames to draw until panels that show `shown` will show `now`: 0 if nothing has
/// changed, 1 if only time went on (position, plots, the camera's picture), else
/// kFramesAfterChange. A change of the position alone counts only from a tenth of a second on.
/// Leaves `now` as it was.
[[nodiscard]] int frames_due(const GuiModel& shown, GuiModel& now);

}  // namespace aucast::gui
