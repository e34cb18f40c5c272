#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "client/gui/gui_commands.h"
#include "client/gui/gui_model.h"
#include "client/gui/thumbnails.h"

namespace aucast::gui {

/// The panels over the face, drawn with Dear ImGui. Owns the ImGui context, its font and its style.
/// Platform and renderer are the caller's (ImGui's backends), so that the same panels are drawn in
/// a window and in tests without one.
/// Thread: the player's; one at a time.
class Gui {
 public:
  /// `scale` of the screen: 1 is 96 dots an inch. A font is looked for where Debian keeps it.
  explicit Gui(float scale);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  /// Makes font and style for this language and size of letters, if these have changed. True: the
  /// texture of the font must be made anew before the backends begin their frame.
  [[nodiscard]] bool prepare(const DisplayView& display);

  /// One frame, after the backends have begun theirs; what is to be drawn is then ImGui's draw
  /// data. What the user asked for goes to the end of `commands`.
  void draw(const GuiModel& model, GuiCommands& commands);

  /// The texture that has the picture of `mirror.seen`, as ImGui's texture ID; 0: none.
  void set_camera_texture(std::uintptr_t texture);

  /// The pictures of faces, by folder.
  [[nodiscard]] Thumbnails& faces();
  /// The pictures of keyframes, by their AUs as in a packet.
  [[nodiscard]] Thumbnails& keyframes();

  void toggle_panel();
  /// Nothing but the face, or panel and bar again.
  void toggle_bare();
  /// Shows panel and bar again; true when they were not shown.
  bool end_bare();
  /// Shows the panel again; true when it was not shown.
  bool show_panel();
  /// In full screen panel and bar lie over the face instead of beside it.
  void set_full_screen(bool full_screen);
  /// Panel, bar and pointer are out of the way for now.
  void set_hidden(bool hidden);
  /// The focus of the keyboard is shown: arrows, Space and the like are for what has it.
  [[nodiscard]] bool focus_shown() const;
  /// False when it was not shown.
  bool hide_focus();
  void toggle_keys();
  /// Hides the list of keys; false when it was not shown.
  bool close_keys();
  /// Closes what is said about the connection; false when there was nothing.
  bool close_notice();
  /// Width of what the panel takes of the window at its right, in its units; 0 when it is hidden or
  /// lies over the face.
  [[nodiscard]] float covered_width() const;
  /// A text is being typed or a question asked: keys are not for the player.
  [[nodiscard]] bool wants_keys() const;
  /// The pointer is over a panel, or drags something of it.
  [[nodiscard]] bool wants_pointer() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace aucast::gui
