#pragma once

#include <imgui.h>

#include "client/gui/model/gui_model.h"

namespace aucast::gui {

/// The width of a scroll bar: half of the panel's margin, because ImGui does not let items use more
/// of the margin.
inline constexpr float kScrollBar = 8;

/// The fonts of ImGui's context. The context must exist when they are loaded and end before this
/// object.
class Fonts {
 public:
  /// Loads fonts that have the letters of the languages of `display`, at this scale, in place of
  /// the present ones. Fonts are looked for where Debian keeps them; if there are none, ImGui's own
  /// is used.
  void load(float scale, const DisplayView& display);
  /// The bold font; the normal one if there is no bold.
  [[nodiscard]] ImFont* bold() const { return bold_; }

 private:
  ImVector<ImWchar> letters_;  ///< the fonts refer to it
  ImFont* bold_ = nullptr;
};

/// Sets the colours, distances and roundings of all panels.
void set_style(float scale);

}  // namespace aucast::gui
