#pragma once

#include <string>

namespace aucast::gui {

// What is said of a control. It stands beside the window or dialog that the control is in, and
// hides none of them.

/// Says more about the item before, while the pointer or the focus is on it and until it is used.
void tip(const std::string& text, bool also_disabled = false);
/// Says something about the item before, wherever the pointer is.
void tip_of_last(const std::string& text);
/// The same about what is drawn at a place of the screen.
void tip_at(float x, float y, const std::string& text);

}  // namespace aucast::gui
