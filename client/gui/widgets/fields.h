#pragma once

#include <span>
#include <string_view>

#include "client/gui/widgets/widgets.h"

namespace aucast::gui {

// Fields in which a value is set. All are called inside an open ImGui window.

/// A slider with its number beside it; returns whether it changed `value`. `width`: of both; below
/// 0: to the end of the line. `column`: text of the widest number in this column of sliders, so
/// that all end at the same place.
[[nodiscard]] bool slider(const char* id, float width, int& value, int least, int most,
                          const char* format, const char* column = "");
[[nodiscard]] bool slider(const char* id, float width, float& value, float least, float most,
                          const char* format);
/// The button "-" or "+" of `owner`, for the mouse only: keys step the item that has the focus.
[[nodiscard]] bool step_button(const char* text, const ImVec2& size, unsigned owner);
/// The steps of a number field, `far` with Ctrl held, and its limits.
struct Steps {
  int near = 1;
  int far = 10;
  int least = 0;
  int most = 1'000'000;
  const char* zero = nullptr;  ///< what is shown instead of 0; null: 0
  int first = 0;               ///< size of the first step up from `zero`; 0: as usual
  bool buttons = true;         ///< - and + beside the number, if there is room
};
/// The least width of a number_field() that has its buttons.
[[nodiscard]] float number_field_width();
/// A whole number that is typed or stepped, by its buttons or by Up and Down. Returns whether it
/// changed `value`. A number beyond the limits is clamped; while it is typed, a text says so.
/// `when_entered`: typing takes effect only with Enter.
[[nodiscard]] bool number_field(const char* id, int& value, const Steps& steps,
                                bool when_entered = false);
/// The same behind a label(), with its tooltip `help`.
bool number_row(const Look& look, const char* name, const char* id, int& value, const Steps& steps,
                const char* help);
/// A slider from 0 to 100 %; returns whether it changed `value`.
[[nodiscard]] bool percent_slider(const char* id, float width, int& value);
/// Whether a change of the previous item continues a drag. A step of undo begins when the mouse is
/// pressed; changes while the button is held belong to that step.
[[nodiscard]] bool belongs_to_drag();

/// Puts a text into a text field's memory, as much of it as there is room for.
void set_text(std::span<char> field, std::string_view text);
/// Makes the next item, a field, leave room at its right for choose_button().
void leave_room_to_choose(const Look& look);
/// The button at the right of that field; it opens the file dialog. Returns whether it was pressed.
[[nodiscard]] bool choose_button(const Look& look);

/// A word to choose, and its tooltip.
struct Word {
  const char* text = "";
  const char* tip = "";
};
/// A choice among a few words on one line; returns whether it changed `chosen`.
[[nodiscard]] bool choice(const char* id, std::span<const Word> words, int& chosen);

/// The line "In between", which sets how values go from one keyframe to the next; returns whether
/// it changed `way`.
[[nodiscard]] bool in_between(const Look& look, const char* id, playback::Interpolation& way);

}  // namespace aucast::gui
