#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "client/gui/model/gui_model.h"
#include "client/gui/model/thumbnails.h"

struct ImFont;
struct ImVec2;

namespace aucast::gui {

// Widgets that several panels use. All are called inside an open ImGui window.

/// What panels need to know besides the model.
struct Look {
  float scale = 1;  ///< of the screen; 1: 96 dots per inch
  ImFont* bold = nullptr;
};

enum class Tone : std::uint8_t { Quiet, Good, Waiting, Bad };

/// The colour for a tone, 0xAABBGGRR as in ImGui.
[[nodiscard]] unsigned colour_of(Tone tone);

/// While it lives, windows get the style of those that lie over the face or the panel.
class FloatingStyle {
 public:
  explicit FloatingStyle(const Look& look);
  ~FloatingStyle();
  FloatingStyle(const FloatingStyle&) = delete;
  FloatingStyle& operator=(const FloatingStyle&) = delete;
};

/// Draws the picture of this name between two corners on the screen; while there is none, a plain
/// background.
void draw_thumbnail(Thumbnails& pictures, const std::string& name, const ImVec2& from,
                    const ImVec2& to);
/// Writes a line in the tone's colour.
void toned_line(Tone tone, const std::string& text);
/// The same, wrapped into as many lines as needed.
void toned_text(Tone tone, const std::string& text);

/// Writes a heading with space above it. `help`: its tooltip.
void heading(const Look& look, const std::string& text, const char* help = "");
/// The same with a small button at the right end of its line, whose identity is `id`. Returns
/// whether the button was pressed.
[[nodiscard]] bool heading_with_button(const Look& look, const std::string& text, const char* help,
                                       const char* button, const char* id, const char* button_help);
/// Writes one line, cut short with "..." if it would go beyond the screen position `right`.
/// `colour` 0: the normal one.
void fitted_text(const std::string& text, float right, unsigned colour = 0);
/// Writes a label at the left. The next item is placed in the panel's column for values, or below
/// the label if the column has too little room. It fills the rest of its line. `help`: the label's
/// tooltip.
void label(const Look& look, const char* text, const char* help);
void quiet_text(const std::string& text);
/// Whether the pointer is on the previous item. Unlike ImGui's hovering, the keyboard focus does
/// not count.
[[nodiscard]] bool pointed_at();
/// The text for a widget, which then has the identity `id` in every language.
[[nodiscard]] std::string with_id(const char* text, const char* id);
/// An entry of a list, which can be found by typing its beginning. `flags`: of ImGui's Selectable.
[[nodiscard]] bool list_item(const std::string& text, bool chosen, int flags = 0);
/// Whether an item of this width fits on the line of the previous item.
[[nodiscard]] bool has_room_beside(float width);
/// A button in part number `share`, counted from 0, of a line that has `shares` equal parts;
/// disabled unless `enabled`. If its text needs more, the button gets wider, and goes to the next
/// line if there is no room.
[[nodiscard]] bool wide_button(const char* text, int share, int shares, bool enabled,
                               bool important = false);
/// Whether a change of the previous item continues a drag. A step of undo begins when the mouse is
/// pressed; changes while the button is held belong to that step.
[[nodiscard]] bool belongs_to_drag();
/// The headings of two columns that share the line, placed as one sees a face: the subject's right
/// at the left.
void sides_heading();
/// A slider with its number beside it; returns whether it changed `value`. `width`: of both; below
/// 0: to the end of the line. `column`: the widest number of the sliders above and below, so that
/// all end at the same place.
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
  int first = 0;               ///< the first step up from a 0 shown as `zero`; 0: the usual step
  bool buttons = true;         ///< - and + beside the number, if there is room
};
/// The least width of a number_field() that has its buttons.
[[nodiscard]] float number_field_width();
/// A whole number that is typed or stepped, by its buttons or by Up and Down. Returns whether it
/// changed `value`. A number beyond the limits is clamped; while it is typed, a text says so.
/// `when_entered`: typing takes effect only with Enter.
[[nodiscard]] bool number_field(const char* id, int& value, const Steps& steps,
                                bool when_entered = false);
/// A slider from 0 to 100 %; returns whether it changed `value`.
[[nodiscard]] bool percent_slider(const char* id, float width, int& value);
/// Draws a buffer as a bar with its fill and a mark for its threshold.
void buffer_bar(const Look& look, const char* name, const BufferBar& bar, const char* help);
/// A line of a plot; values in [0,1], oldest first.
struct PlotLine {
  const std::vector<float>* values = nullptr;
  unsigned colour = 0;
  std::string label{};  ///< written beside its end; empty: none
  int marker = -1;      ///< the sign drawn along it, as in line_name(); -1: none
};
/// Makes the next item, a field, leave room at its right for choose_button().
void leave_room_to_choose(const Look& look);
/// The button at the right of that field; it opens the file dialog. Returns whether it was pressed.
[[nodiscard]] bool choose_button(const Look& look);

/// What is written at a plot's edges; empty: nothing.
struct PlotScale {
  float mark = 0;           ///< a level to reach, in [0,1]; 0: none
  std::string mark_text{};  ///< above the line of `mark`
  std::string top{};        ///< what a value of 1 is
  std::string begin{};      ///< at the left end, where the half minute begins
  std::string end{};        ///< at the right end, where it ends
};
/// Draws lines over the last half minute, the newest values at the right, across the whole width.
/// Returns whether it was clicked.
bool plot(const Look& look, std::span<const PlotLine> lines, float height, const PlotScale& scale);
/// Writes the name of a line in its colour, after its sign, because colours alone do not tell lines
/// apart.
void line_name(const Look& look, int marker, const std::string& name);
/// The colour of a line in a plot of several.
[[nodiscard]] unsigned colour_of_line(std::size_t index);

/// The texts around a table of AUs: the heading and tip of the first column (the AUs as they came),
/// a legend, and the tip of the second column.
struct AuTableWords {
  const char* given = "";
  const char* given_tip = "";
  const char* legend = "";
  const char* shown_tip = "";
};
void au_table(const Look& look, const AuTableWords& words, const std::vector<AuRow>& rows);

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
