#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "client/gui/gui_model.h"
#include "client/gui/thumbnails.h"

struct ImFont;
struct ImVec2;

namespace aucast::gui {

// Small things that several panels draw. All of them inside an open ImGui window.

/// What panels need to know beside the model.
struct Look {
  float scale = 1;  ///< of the screen: 1 is 96 dots an inch
  ImFont* bold = nullptr;
};

enum class Tone : std::uint8_t { Quiet, Good, Waiting, Bad };

/// Colours by what they mean, 0xAABBGGRR as ImGui packs them.
[[nodiscard]] unsigned colour_of(Tone tone);

/// How a window looks that lies over the face or the panel; as long as it lives.
class FloatingStyle {
 public:
  explicit FloatingStyle(const Look& look);
  ~FloatingStyle();
  FloatingStyle(const FloatingStyle&) = delete;
  FloatingStyle& operator=(const FloatingStyle&) = delete;
};

/// The picture of this name between two corners on the screen; a plain ground while there is none.
void draw_thumbnail(Thumbnails& pictures, const std::string& name, const ImVec2& from,
                    const ImVec2& to);
/// A line in the tone's colour.
void toned_line(Tone tone, const std::string& text);
/// The same, broken into as many lines as it needs.
void toned_text(Tone tone, const std::string& text);

/// A heading with room above it.
/// `help`: of the word, while the pointer is on it.
void heading(const Look& look, const std::string& text, const char* help = "");
/// One line that ends with "..." where it would go beyond `right` of the screen; `colour` 0: that
/// of all text.
void fitted_text(const std::string& text, float right, unsigned colour = 0);
/// A label at the left; what comes next stands at the panel's column for values and fills the rest.
void label(const Look& look, const char* text, const char* help = "");
void quiet_text(const std::string& text);
/// The pointer is on the item before; unlike ImGui's hovering not the focus of the keyboard.
[[nodiscard]] bool pointed_at();
/// A text for a widget that is known by `id` in every language.
[[nodiscard]] std::string with_id(const char* text, const char* id);
/// A line of a list, which typing its beginning finds; `flags` of ImGui's Selectable.
[[nodiscard]] bool list_item(const std::string& text, bool chosen, int flags = 0);
/// Something so wide fits on the line of the item before.
[[nodiscard]] bool has_room_beside(float width);
/// A button that fills its share of the line: `share` of `shares`, drawn as disabled unless
/// `enabled`. One whose text needs more takes it, and goes to the next line where there is no room.
[[nodiscard]] bool wide_button(const char* text, int share, int shares, bool enabled,
                               bool important = false);
/// Whether a change of the item before belongs to the press of the mouse that began it: the press
/// is the beginning of a step, and what follows while it is held belongs to that step.
[[nodiscard]] bool belongs_to_drag();
/// The headings of two columns that share the line, as one sees a face: the subject's right is at
/// the viewer's left.
void sides_heading();
/// A slider with its number beside it, together so wide; below 0: what is left of the line. True
/// when it changed `value`.
/// `column`: the widest number of the sliders above and below, which end together.
[[nodiscard]] bool slider(const char* id, float width, int& value, int least, int most,
                          const char* format, const char* column = "");
[[nodiscard]] bool slider(const char* id, float width, float& value, float least, float most,
                          const char* format);
/// "-" or "+" of `owner`, for the mouse: keys step in what has the focus.
[[nodiscard]] bool step_button(const char* text, const ImVec2& size, unsigned owner);
/// What a number field steps by, Ctrl held or not, and its limits.
struct Steps {
  int near = 1;
  int far = 10;
  int least = 0;
  int most = 1'000'000;
  const char* zero = nullptr;  ///< what 0 means, in its place; null: it is a number like others
  int first = 0;               ///< the first step up from such a 0; 0: as every other
  bool buttons = true;         ///< left out also where there is no room beside the number
};
/// A whole number that is typed or stepped, by its buttons or by Up and Down; true when it changed
/// `value`. What is typed beyond the limits is cut, and that is said while it stands there.
/// `when_entered`: typing counts at Enter.
[[nodiscard]] bool number_field(const char* id, int& value, const Steps& steps,
                                bool when_entered = false);
/// A slider of 0 to 100 %; true when it changed `value`.
[[nodiscard]] bool percent_slider(const char* id, float width, int& value);
/// A buffer as a bar with its fill and the mark of its threshold.
void buffer_bar(const Look& look, const char* name, const BufferBar& bar, const char* help);
/// A line of a plot; values in [0,1], oldest first.
struct PlotLine {
  const std::vector<float>* values = nullptr;
  unsigned colour = 0;
  std::string label{};  ///< beside its end; empty: none
  int marker = -1;      ///< the sign of line_name() along it; -1: none
};
/// Lines over the last half minute, the newest at the right; `mark` in [0,1] is a level to reach, 0
/// for none. As wide as there is room. True when it was clicked.
bool plot(const Look& look, std::span<const PlotLine> lines, float height, float mark);
/// Colours are not all that tells lines apart: a name in the line's colour, behind its sign.
void line_name(const Look& look, int marker, const std::string& name);
/// A colour for each of a few lines that stand together.
[[nodiscard]] unsigned colour_of_line(std::size_t index);

/// The heading of the column of AUs as they came, and why others are shown.
struct AuTableWords {
  const char* given = "";
  const char* given_tip = "";
  const char* legend = "";
  const char* shown_tip = "";
};
void au_table(const Look& look, const AuTableWords& words, const std::vector<AuRow>& rows);

/// A choice among a few words on one line; true when it changed `chosen`.
template <std::size_t N>
[[nodiscard]] bool choice(const char* id, const std::array<const char*, N>& words, int& chosen);
[[nodiscard]] bool choice_of(const char* id, const char* const* words, int count, int& chosen);

template <std::size_t N>
bool choice(const char* id, const std::array<const char*, N>& words, int& chosen) {
  return choice_of(id, words.data(), static_cast<int>(N), chosen);
}

/// The line "In between": how values go from one to the next; true when it changed `way`.
[[nodiscard]] bool in_between(const Look& look, const char* id, playback::Interpolation& way);

}  // namespace aucast::gui
