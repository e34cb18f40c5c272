#pragma once

#include <string>
#include <string_view>

struct ImGuiWindow;

namespace aucast::gui {

/// What is typed to find something in a list.
class TypeAhead {
 public:
  /// Takes what was typed since the last frame; `listens`: a list is open and no text is edited.
  void take(bool listens, double now);
  /// Whether this is the first since something was typed that begins with it, or does so behind a
  /// number: both "12" and "lip" find "12 Lip Corner Puller".
  [[nodiscard]] bool finds(std::string_view label);

 private:
  std::string typed_;
  double last_ = 0;
  bool looks_ = false;  ///< what was typed has not been found yet
};

/// That of the list that is open.
[[nodiscard]] TypeAhead& type_ahead();

/// The focus of the keyboard among the panels. Tab shows it and moves it through all that can be
/// used, window after window and around, Shift and Tab back; arrows move it nearby, Enter and Space
/// use what has it. Esc and a click hide it. ImGui 1.86 itself stops at fields alone and stays in
/// one window.
class KeyboardFocus {
 public:
  /// `opens`: a dialog with a list is open, or will be in this frame.
  void before_frame(bool opens);
  /// Behind ImGui::NewFrame().
  void begin();
  /// Before ImGui::Render().
  void end();
  [[nodiscard]] bool shown() const { return shown_; }
  /// False when it was not shown.
  bool hide();

 private:
  void look_in(ImGuiWindow* window, int direction);

  bool shown_ = false;
  bool looks_ = false;       ///< in this frame, for the next thing that can be used
  bool enters_ = false;      ///< nothing in this window had it
  bool alive_ = false;       ///< what had the focus was there in the frame before
  bool moves_ = false;       ///< it was found in the frame before
  bool to_slider_ = false;   ///< what was found is none to type in at once
  int direction_ = 0;        ///< -1: back
  std::string next_window_;  ///< where to go on looking; empty: nowhere
};

/// A slider, as long as it lives: the focus comes to it without beginning to type a number.
class SliderScope {
 public:
  SliderScope();
  ~SliderScope();
  SliderScope(const SliderScope&) = delete;
  SliderScope& operator=(const SliderScope&) = delete;
};

/// What the arrows do to an item that draws itself, in steps: to the right, and up.
struct ArrowSteps {
  int right = 0;
  int up = 0;
  bool held = false;       ///< the item is taken, and the arrows are its
  bool continued = false;  ///< not the first step since it was taken
};

/// Of the item before, a button that was `pressed` or not: Space and Enter take it and let it go,
/// Esc and Tab let it go, as with a slider.
[[nodiscard]] ArrowSteps arrows_of_item(bool pressed);
/// The mouse holds the item before.
[[nodiscard]] bool held_by_mouse();

/// Behind a field of text: Enter has ended it, and what is typed next is still meant for it and no
/// shortcut. It stays, all of it chosen, until Esc, Tab or a click.
void stay_in_field();

/// What only a mouse can use, as long as it lives: there are keys for it elsewhere.
class MouseOnly {
 public:
  MouseOnly();
  ~MouseOnly();
  MouseOnly(const MouseOnly&) = delete;
  MouseOnly& operator=(const MouseOnly&) = delete;
};

/// Puts the focus on the item before, where it is seen; `shows`: the focus too.
void focus_here(bool shows);
/// The item before has the focus, and that is seen.
[[nodiscard]] bool focus_is_here();
/// What was just pressed was so without the mouse.
[[nodiscard]] bool used_by_keys();
/// Around the item before, if it has the focus: for items that draw themselves.
void mark_focus();

}  // namespace aucast::gui
