#pragma once

#include <array>
#include <memory>

#include "client/gui/gui.h"
#include "client/render/window.h"

namespace aucast::app {

/// The panels in a window: joins gui::Gui with ImGui's backends for GLFW and OpenGL. The window
/// must outlive it, and its context must be current.
class WindowOverlay {
 public:
  explicit WindowOverlay(render::Window& window);
  ~WindowOverlay();
  WindowOverlay(const WindowOverlay&) = delete;
  WindowOverlay& operator=(const WindowOverlay&) = delete;

  /// Draws over what the window shows; what was asked for goes to the end of `commands`.
  void draw(const gui::GuiModel& model, gui::GuiCommands& commands);
  /// There is input that only the next frame may see.
  [[nodiscard]] bool input_waits() const;
  /// Pixels of the framebuffer that the panel leaves free, from the left.
  [[nodiscard]] int free_width(int framebuffer_width) const;
  [[nodiscard]] gui::Gui& gui() { return gui_; }

 private:
  void feed();

  render::Window& window_;
  float pointer_x_ = -1e6F;
  float pointer_y_ = -1e6F;
  std::array<bool, 3> buttons_{};
  gui::Gui gui_;
};

}  // namespace aucast::app
