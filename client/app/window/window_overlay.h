#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "client/app/window/input_pacer.h"
#include "client/app/window/panel_mouse.h"
#include "client/gui/gui.h"
#include "client/gui/model/curtain.h"
#include "client/render/picture_texture.h"
#include "client/render/window.h"

namespace aucast::app {

/// The panels in a window: connects gui::Gui with ImGui's backends for GLFW and OpenGL. The window
/// must outlive it, and its context must be current.
class WindowOverlay {
 public:
  explicit WindowOverlay(render::Window& window);
  ~WindowOverlay();
  WindowOverlay(const WindowOverlay&) = delete;
  WindowOverlay& operator=(const WindowOverlay&) = delete;

  /// Draws over what the window shows, and appends the commands of the user to `commands`. Outside
  /// the panels the mouse moves the viewpoint: the left button turns it, the right button moves it,
  /// the wheel zooms.
  void draw(const gui::GuiModel& model, gui::GuiCommands& commands);
  /// The next key that was pressed and not typed into something; Key::None: there are no more.
  [[nodiscard]] render::Key next_key();
  void set_full_screen(bool full_screen, Instant now);
  /// Hides panels while the mouse is still, and shows them when it moves. Returns whether it has
  /// hidden or shown them. Call it before draw().
  [[nodiscard]] bool move_curtain(Instant now);
  /// When to call move_curtain() next if nothing happens before; nullopt: no need to.
  [[nodiscard]] std::optional<Instant> curtain_falls_at(Instant now) const {
    return curtain_.falls_at(now);
  }
  /// Whether there is input that only the next frame may see.
  [[nodiscard]] bool input_waits() const;
  /// How many pixels of the framebuffer the panel leaves free, from the left.
  [[nodiscard]] int free_width(int framebuffer_width) const;
  [[nodiscard]] gui::Gui& gui() { return gui_; }

 private:
  void feed();
  void take(const render::InputEvent& event);
  void move_to(const render::InputEvent& event);
  void upload_picture(const gui::MirrorView& mirror);

  render::Window& window_;
  InputPacer pacer_;
  gui::Curtain curtain_;
  bool hidden_ = false;
  std::deque<render::Key> keys_;
  PanelMouse mouse_;
  render::PictureTexture texture_;
  std::shared_ptr<const preview::Seen> in_texture_;
  gui::Gui gui_;
};

}  // namespace aucast::app
