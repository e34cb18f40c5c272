#pragma once

#include <imgui.h>

#include "client/gui/gui_model.h"

namespace aucast::gui {

/// Half of the panel's margin, which is what ImGui lets things use of it.
inline constexpr float kScrollBar = 8;

/// The fonts of ImGui's context, which must be there and ends before this object.
class Fonts {
 public:
  /// In place of those that were there: letters for the languages of `display`, at this scale. A
  /// font is looked for where Debian keeps it; without one ImGui's own is used.
  void load(float scale, const DisplayView& display);
  /// The heavier weight; ImGui's own font has only one.
  [[nodiscard]] ImFont* bold() const { return bold_; }

 private:
  ImVector<ImWchar> letters_;  ///< which the fonts refer to
  ImFont* bold_ = nullptr;
};

/// Colours, distances and roundings of all panels.
void set_style(float scale);

}  // namespace aucast::gui
