#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "client/gui/model/gui_commands.h"
#include "client/gui/model/gui_model.h"
#include "client/gui/model/thumbnails.h"

namespace aucast::gui {

/// The panels over the face, drawn with Dear ImGui. Owns the ImGui context, its font and its style.
/// The caller provides ImGui's backends for platform and renderer, so that the same panels can be
/// drawn in a window and in tests without one.
/// Thread: the player's. Only one may exist at a time.
class Gui {
 public:
  /// `scale` of the screen; 1: 96 dots per inch. Fonts are looked for where Debian keeps them.
  explicit Gui(float scale);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  /// If the language or the size of letters has changed, makes font and style for them and returns
  /// true. The font's texture must then be made anew before the backends begin their frame.
  [[nodiscard]] bool prepare(const DisplayView& display);

  /// Call it with the model that the next frames will be drawn from, before the input for those
  /// frames is taken: a dialog that opens gets the keys in its very first frame.
  void expect(const GuiModel& model);

  /// Makes one frame, after the backends have begun theirs; the result is ImGui's draw data. What
  /// the user asks for is appended to `commands`.
  void draw(const GuiModel& model, GuiCommands& commands);

  /// Whether rows of the panel have moved under the pointer in the last frame. Do not show that
  /// frame: in the next one the rows are in their place again.
  [[nodiscard]] bool rows_moved() const;

  /// Sets the texture that has the picture of `mirror.seen`, as ImGui's texture ID; 0: none.
  void set_camera_texture(std::uintptr_t texture);

  /// The pictures of faces, by folder.
  [[nodiscard]] Thumbnails& faces();
  /// The pictures of keyframes, by their AUs as in a packet.
  [[nodiscard]] Thumbnails& keyframes();

  void toggle_panel();
  /// Shows only the face, or shows panel and bar again.
  void toggle_bare();
  /// Shows panel and bar again; returns whether that makes a visible difference.
  bool end_bare();
  /// Shows the panel again; returns whether that makes a visible difference.
  bool show_panel();
  /// Hides panel, bar and pointer for now, or shows them again.
  void set_hidden(bool hidden);
  /// Whether the keyboard focus is shown. Arrows, Space and the like then go to the item that has
  /// the focus.
  [[nodiscard]] bool focus_shown() const;
  /// Hides the keyboard focus; returns whether it was shown.
  bool hide_focus();
  void toggle_keys();
  /// Hides the list of keys; returns whether it was shown.
  bool close_keys();
  /// Closes the notice about the connection; returns whether there was one.
  bool close_notice();
  /// The width that the panel takes at the window's right, in ImGui's units; 0 if it is hidden. The
  /// face is drawn in what is left, in full screen too.
  [[nodiscard]] float covered_width() const;
  /// Whether a text is being typed or a question asked, so that keys are not commands of the
  /// player.
  [[nodiscard]] bool wants_keys() const;
  /// Whether the pointer is over a panel or drags something in it.
  [[nodiscard]] bool wants_pointer() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace aucast::gui
