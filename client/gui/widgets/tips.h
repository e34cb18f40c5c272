#pragma once

#include <string>

namespace aucast::gui {

// Tooltips. They appear beside the window or dialog that their item is in, so that they hide none
// of its controls.

/// Shows a tooltip for the previous item while the pointer or focus is on it, until the item is
/// used.
void tip(const std::string& text, bool also_disabled = false);
/// Shows a tooltip for the previous item, wherever the pointer is.
void tip_of_last(const std::string& text);
/// Shows a tooltip for what is drawn at a place of the screen.
void tip_at(float x, float y, const std::string& text);

}  // namespace aucast::gui
