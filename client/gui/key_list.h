#pragma once

#include "client/gui/widgets.h"

namespace aucast::gui {

/// What each key does, over the face; `width`: what the side panel leaves free. The user closes it
/// by `shown`.
void key_list(const Look& look, float width, bool& shown);

}  // namespace aucast::gui
