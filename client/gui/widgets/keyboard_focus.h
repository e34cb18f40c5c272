#pragma once

#include <string>
#include <string_view>

struct ImGuiWindow;

namespace aucast::gui {

/// What was typed since the last frame, without control characters.
[[nodiscard]] std::string typed_text();

/// What the user types to find an entry of a list.
class TypeAhead {
 public:
  /// Takes typed_text(). `listens`: whether a list is open and no text is
  /// edited. `now`: in seconds.
  void take(bool listens, double now);
  /// Call it for each entry in turn. True for the first one that has what was typed at its
  /// beginning or right after its number: both "12" and "lip" find "12 Lip Corner Puller".
  [[nodiscard]] bool finds(std::string_view label);

 private:
  std::string typed_;
  double last_ = 0;
  bool looks_ = false;  ///< no entry has matched yet
};

/// The TypeAhead of the list that is open.
[[nodiscard]] TypeAhead& type_ahead();

/// The keyboard focus in the panels. Tab shows it and moves it through everything that can be used,
/// from window to window and round again; Shift+Tab goes back. Arrows move it to items nearby,
/// Enter and Space use the item that has it. Esc and a click hide it. Without this class, ImGui
/// 1.86 stops only at fields and stays in one window.
class KeyboardFocus {
 public:
  /// `opens`: a dialog with a list is open, or will be in this frame.
  void before_frame(bool opens);
  /// Call it after ImGui::NewFrame().
  void begin();
  /// Call it before ImGui::Render().
  void end();
  [[nodiscard]] bool shown() const { return shown_; }
  /// Hides the focus; returns whether it was shown.
  bool hide();

 private:
  void look_in(ImGuiWindow* window, int direction);

  bool shown_ = false;
  bool looks_ = false;       ///< in this frame, the next item that can be used is looked for
  bool enters_ = false;      ///< no item in this window had the focus
  bool alive_ = false;       ///< the item with the focus was there in the previous frame
  bool moves_ = false;       ///< an item was found in the previous frame
  bool to_slider_ = false;   ///< the item found is a slider, so the focus must not begin to type a
                             ///< number
  int direction_ = 0;        ///< -1: back
  std::string next_window_;  ///< the window in which to go on looking; empty: none
};

/// While it lives, the items that are made are of this kind.
class ItemsAre {
 public:
  enum Kind : int {
    Sliders,   ///< the focus comes to them without beginning to type a number
    MouseOnly  ///< the focus does not come to them, because keys do the same in another way
  };
  explicit ItemsAre(Kind kind);
  ~ItemsAre();
  ItemsAre(const ItemsAre&) = delete;
  ItemsAre& operator=(const ItemsAre&) = delete;
};

/// What the arrows do to an item that draws itself, in steps to the right and up.
struct ArrowSteps {
  int right = 0;
  int up = 0;
  bool held = false;       ///< the user has taken hold of the item, so that arrows are for it
  bool continued = false;  ///< not the first step since the user took hold
};

/// Call it after a button. `pressed`: what the button returned. As with a slider, Space and Enter
/// take hold of the item and let it go; Esc and Tab let it go.
[[nodiscard]] ArrowSteps arrows_of_item(bool pressed);
/// Whether the mouse holds the previous item.
[[nodiscard]] bool held_by_mouse();

/// Call it after a text field in which the user tries one text after another. When Enter has ended
/// a text, the field stays active with all its text selected until Esc, Tab or a click, because
/// what is typed next is still meant for the field and is no shortcut. Do not call it after a field
/// that keeps a setting, such as a path: the next key would replace the setting.
void stay_in_field();
/// Makes the text field `id`, which comes next, active in this frame. ImGui itself would take some
/// frames, in which more is typed.
void enter_field(const char* id);
/// Puts the cursor behind what is in the previous item, a text field that has just become active.
void go_to_end_of_field();

/// Closes the topmost drop-down or menu if Esc was pressed; a dialog answers for itself. ImGui does
/// so only while its keyboard navigation is on.
void close_popup_by_escape();

/// Gives the focus to the previous item and scrolls to it. `shows`: the focus is shown from then
/// on.
void focus_here(bool shows);
/// Whether the previous item has the focus, and the focus is shown.
[[nodiscard]] bool focus_is_here();
/// Whether Enter was pressed while no item takes it, that is, while the focus is not shown and no
/// item is active.
[[nodiscard]] bool entered_nowhere();
/// Whether the item that was just pressed was pressed by a key.
[[nodiscard]] bool used_by_keys();
/// Draws the focus around the previous item if that has the focus. For items that draw themselves.
void mark_focus();

}  // namespace aucast::gui
