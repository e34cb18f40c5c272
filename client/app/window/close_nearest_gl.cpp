#include "client/app/window/close_nearest.h"

namespace aucast::app {

Escaped close_nearest(gui::Gui& gui, const gui::GuiModel& shown, bool full_screen) {
  Escaped escaped;
  if (gui.close_keys()) return escaped;
  if (!shown.notice.text.empty()) {
    escaped.commands.push_back(gui::CloseNotice{});
    if (!full_screen) return escaped;
  }
  if (gui.close_notice() && !full_screen) return escaped;
  if (shown.gallery.open) {
    escaped.commands.push_back(gui::GalleryCommand(gui::CloseGallery{}));
    return escaped;
  }
  if (gui.end_bare() || gui.show_panel() || gui.hide_focus()) return escaped;
  escaped.ends_full_screen = full_screen;
  return escaped;
}

}  // namespace aucast::app
