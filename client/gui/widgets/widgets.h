#pragma once

#include <cstdint>
#include <string>

#include "client/gui/model/gui_model.h"
#include "client/gui/model/thumbnails.h"

struct ImFont;
struct ImVec2;

namespace aucast::gui {

// Texts, headings, buttons and bars that several panels use. All are called inside an open ImGui
// window.

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
/// A line that a click opens and closes, which reaches over the panel; returns whether it is open.
[[nodiscard]] bool foldable(const char* text);
/// A window that is just large enough for its text, over the face. `anchor`: which part of its
/// height is at `at`, 0 to 1; its middle is there. `wrap`: the width at which lines break.
/// `flags`: of ImGui, besides those of a bare window. Returns its height.
float text_window(const char* id, const std::string& text, const ImVec2& at, float anchor,
                  float wrap, int flags = 0);
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
/// The headings of two columns that share the line, placed as one sees a face: the subject's right
/// at the left.
void sides_heading();
/// Draws a buffer as a bar with its fill and a mark for its threshold.
void buffer_bar(const Look& look, const char* name, const BufferBar& bar, const char* help);

}  // namespace aucast::gui
