#pragma once

#include "client/app/window/window_session.h"
#include "client/gui/model/gui_model.h"

namespace aucast::app {

/// What the panels show of the sessions. Videos and the pace of drawing are not theirs; the caller
/// adds them.
[[nodiscard]] gui::GuiModel model_of(const WindowSession& session);

}  // namespace aucast::app
