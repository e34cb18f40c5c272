#pragma once

#include "client/gui/widgets/widgets.h"

namespace aucast::gui {

/// Shows over the face a list of what each key does. `width`: what the side panel leaves free.
/// `shown` becomes false when the user closes it.
void key_list(const Look& look, float width, bool& shown);

}  // namespace aucast::gui
