#pragma once

#include <array>
#include <deque>
#include <memory>
#include <optional>

#include "client/app/window/input_pacer.h"
#include "client/gui/curtain.h"
#include "client/gui/gui.h"
#include "client/render/picture_texture.h"
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

  /// Draws over what the window shows; what was asked for goes to the end of `commands`. What is
  /// not done on a panel moves the viewpoint: left drag turns, right drag moves, the wheel zooms.
  void draw(const gui::GuiModel& model, gui::GuiCommands& commands);
  /// Keys pressed and not typed into something, in order; Key::None when there are no more.
  [[nodiscard]] render::Key next_key();
  void set_full_screen(bool full_screen, Instant now);
  /// Lets panels go or come back as the mouse is still or moves; true when they did. Call it before
  /// draw().
  [[nodiscard]] bool move_curtain(Instant now);
  /// When move_curtain() is to be called again if nothing happens until then.
  [[nodiscard]] std::optional<Instant> curtain_falls_at(Instant now) const {
    return curtain_.falls_at(now);
  }
  /// There is input that only the next frame may see.
  [[nodiscard]] bool input_waits() const;
  /// Pixels of the framebuffer that the panel leaves free, from the left.
  [[nodiscard]] int free_width(int framebuffer_width) const;
  [[nodiscard]] gui::Gui& gui() { return gui_; }

 private:
  /// Where a pointer is that left the window.
  static constexpr float kNowhere = -1e6F;

  void feed();
  void take(const render::InputEvent& event);
  void move_to(float x, float y);
  void upload_picture(const gui::MirrorView& mirror);

  render::Window& window_;
  InputPacer pacer_;
  gui::Curtain curtain_;
  bool hidden_ = false;
  std::deque<render::Key> keys_;
  float pointer_x_ = kNowhere;
  float pointer_y_ = kNowhere;
  std::array<bool, 3> buttons_{};
  render::PictureTexture texture_;
  std::shared_ptr<const preview::Seen> in_texture_;
  gui::Gui gui_;
};

}  // namespace aucast::app
