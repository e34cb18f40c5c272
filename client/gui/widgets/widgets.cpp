#include "client/gui/widgets/widgets.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

#include "client/gui/texts/texts.h"
#include "client/gui/widgets/kept_place.h"
#include "client/gui/widgets/keyboard_focus.h"
#include "client/gui/widgets/tips.h"

namespace aucast::gui {
namespace {

constexpr float kLabelWidth = 112;
/// Room, in letters' heights, without which a control stands below its label, not beside it.
constexpr float kControlWidth = 7;

ImVec4 accent() {
  return ImGui::GetStyleColorVec4(ImGuiCol_PlotLines);
}

/// Breaks lines only at spaces: ImGui would break "0.7" as well. It breaks a word that is longer
/// than a line.
std::string in_lines(const std::string& text, float width) {
  std::string lines;
  std::size_t line_begin = 0;
  std::size_t word_begin = 0;
  while (word_begin < text.size()) {
    const std::size_t word_end = std::min(text.find(' ', word_begin), text.size());
    const float reach = ImGui::CalcTextSize(text.data() + line_begin, text.data() + word_end).x;
    if (reach > width && word_begin > line_begin) {
      lines.back() = '\n';
      line_begin = word_begin;
    }
    lines.append(text, word_begin, word_end - word_begin);
    if (word_end < text.size()) lines += ' ';
    word_begin = word_end + 1;
  }
  return lines;
}

}  // namespace

unsigned colour_of(Tone tone) {
  switch (tone) {
    case Tone::Quiet:
      return IM_COL32(140, 147, 158, 255);
    case Tone::Good:
      return IM_COL32(104, 190, 140, 255);
    case Tone::Waiting:
      return IM_COL32(226, 182, 92, 255);
    case Tone::Bad:
      return IM_COL32(235, 116, 104, 255);
  }
  return IM_COL32_WHITE;
}

FloatingStyle::FloatingStyle(const Look& look) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6 * look.scale);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, look.scale);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
}

FloatingStyle::~FloatingStyle() {
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
}

void draw_thumbnail(Thumbnails& pictures, const std::string& name, const ImVec2& from,
                    const ImVec2& to) {
  pictures.seen.push_back(name);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  const auto found = pictures.textures.find(name);
  if (found == pictures.textures.end()) {
    return list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg), rounding);
  }
  list.AddImageRounded(reinterpret_cast<ImTextureID>(found->second), from, to, ImVec2(0, 0),
                       ImVec2(1, 1), IM_COL32_WHITE, rounding);
}

void toned_line(Tone tone, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour_of(tone));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
}

void toned_text(Tone tone, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour_of(tone));
  ImGui::TextWrapped("%s", text.c_str());
  ImGui::PopStyleColor();
}

void heading(const Look& look, const std::string& text, const char* help) {
  mark_row(text);
  ImGui::Dummy(ImVec2(0, 5 * look.scale));
  ImGui::PushFont(look.bold);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopFont();
  tip(help);
  ImGui::Dummy(ImVec2(0, 0));
}

bool heading_with_button(const Look& look, const std::string& text, const char* help,
                         const char* button, const char* id, const char* button_help) {
  const ImVec2 padding = ImGui::GetStyle().FramePadding;
  const float inset = 2 * look.scale;
  const float top = ImGui::GetCursorPosY() + 5 * look.scale + ImGui::GetStyle().ItemSpacing.y;
  heading(look, text, help);
  const ImVec2 below = ImGui::GetCursorPos();
  const float width = ImGui::CalcTextSize(button).x + 2 * padding.x;
  ImGui::SetCursorPos(ImVec2(ImGui::GetContentRegionMax().x - width, top - inset));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(padding.x, inset));
  const bool pressed = ImGui::Button(with_id(button, id).c_str());
  ImGui::PopStyleVar();
  tip(button_help);
  ImGui::SetCursorPos(below);
  return pressed;
}

void fitted_text(const std::string& text, float right, unsigned colour) {
  const float shift = ImGui::GetCurrentWindow()->DC.CurrLineTextBaseOffset;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 from(at.x, at.y + shift);
  const ImVec2 whole = ImGui::CalcTextSize(text.c_str());
  const ImVec2 to(std::max(right, from.x), from.y + whole.y);
  if (colour != 0) ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), from, to, to.x, to.x, text.c_str(), nullptr,
                            &whole);
  if (colour != 0) ImGui::PopStyleColor();
  ImGui::Dummy(ImVec2(std::min(whole.x, to.x - from.x), whole.y + shift));
}

void label(const Look& look, const char* text, const char* help) {
  mark_row(text);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  tip(help);
  const float beside = ImGui::GetStyle().WindowPadding.x + kLabelWidth * look.scale;
  const float room = ImGui::GetWindowContentRegionMax().x - beside;
  if (room >= kControlWidth * ImGui::GetFontSize()) ImGui::SameLine(beside);
  ImGui::SetNextItemWidth(-1);
}

bool pointed_at() {
  return ImGui::IsItemHovered() &&
         ImGui::IsMouseHoveringRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

std::string with_id(const char* text, const char* id) {
  return std::string(text) + "###" + id;
}

void quiet_text(const std::string& text) {
  const std::string lines = in_lines(text, ImGui::GetContentRegionAvail().x - 1);
  ImGui::PushStyleColor(ImGuiCol_Text, colour_of(Tone::Quiet));
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(lines.data(), lines.data() + lines.size());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

bool foldable(const char* text) {
  return ImGui::TreeNodeEx(text,
                           ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen);
}

float text_window(const char* id, const std::string& text, const ImVec2& at, float anchor,
                  float wrap, int flags) {
  // The size is given: ImGui would find it one frame late, and cut a text that is longer than the
  // last until the next frame, which may be long in coming.
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
  ImGui::SetNextWindowSize(ImVec2(size.x + 2 * padding.x, size.y + 2 * padding.y));
  ImGui::SetNextWindowPos(at, ImGuiCond_Always, ImVec2(0.5F, anchor));
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoFocusOnAppearing;
  ImGui::Begin(id, nullptr, kFlags | flags);
  ImGui::PushTextWrapPos(padding.x + wrap);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  return ImGui::GetWindowHeight();
}

bool list_item(const std::string& text, bool chosen, int flags) {
  const bool pressed = ImGui::Selectable(text.c_str(), chosen, flags);
  if (chosen && ImGui::IsWindowAppearing()) ImGui::SetItemDefaultFocus();
  if (type_ahead().finds(text)) focus_here(true);
  return pressed;
}

bool has_room_beside(float width) {
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  const float left = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x;
  return left + width <= right + 0.5F;
}

bool wide_button(const char* text, int share, int shares, bool enabled, bool important) {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = ImGui::GetWindowContentRegionMax().x - ImGui::GetWindowContentRegionMin().x;
  const auto count = static_cast<float>(shares);
  const float even = (width - gap * (count - 1)) / count;
  const ImVec2 padding(ImGui::GetStyle().FramePadding.x / 2, ImGui::GetStyle().FramePadding.y);
  const float needed = ImGui::CalcTextSize(text).x + 2 * padding.x;
  const float each = std::min(std::max(even, needed), width);
  if (share > 0 && has_room_beside(each)) ImGui::SameLine();
  mark_row(text);
  if (important) {
    const ImVec4 lighter = ImGui::GetStyleColorVec4(ImGuiCol_PlotLinesHovered);
    ImGui::PushStyleColor(ImGuiCol_Button, accent());
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, lighter);
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, lighter);
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0.06F, 0.08F, 0.10F, 1));
  }
  ImGui::BeginDisabled(!enabled);
  // ImGui centres a text only in what its padding leaves free.
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, padding);
  const std::string label = needed > each ? in_lines(text, each - 2 * padding.x) : text;
  const bool pressed = ImGui::Button(label.c_str(), ImVec2(each, 0));
  ImGui::PopStyleVar();
  ImGui::EndDisabled();
  if (important) ImGui::PopStyleColor(4);
  return pressed;
}

void sides_heading() {
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float half = (ImGui::GetContentRegionAvail().x - gap) / 2;
  const float left = ImGui::GetCursorPosX();
  const auto centred = [&](const char* text, float column) {
    ImGui::SetCursorPosX(column + (half - ImGui::CalcTextSize(text).x) / 2);
    quiet_text(text);
  };
  centred(tr("panel.right_side"), left);
  ImGui::SameLine();
  centred(tr("panel.left_side"), left + half + gap);
}

void buffer_bar(const Look& look, const char* name, const BufferBar& bar, const char* help) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(name);
  tip(help);
  ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + kLabelWidth * look.scale);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, ImGui::GetFrameHeight());
  const ImVec2 to(from.x + size.x, from.y + size.y);
  const float rounding = ImGui::GetStyle().FrameRounding;
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg), rounding);
  const auto capacity = static_cast<float>(std::max<std::size_t>(bar.capacity, 1));
  const float share = std::min(1.0F, static_cast<float>(bar.fill) / capacity);
  if (share > 0) {
    ImVec4 colour = accent();
    colour.w = 0.55F;
    list->AddRectFilled(from, ImVec2(from.x + size.x * share, to.y), ImGui::GetColorU32(colour),
                        rounding);
  }
  if (bar.threshold_percent > 0) {
    const float x = from.x + size.x * static_cast<float>(bar.threshold_percent) / 100.0F;
    const float half = look.scale;
    list->AddRectFilled(ImVec2(x - half, from.y), ImVec2(x + half, to.y), colour_of(Tone::Waiting));
  }
  const std::string text = std::to_string(bar.fill) + " / " + std::to_string(bar.capacity);
  const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
  list->AddText(ImVec2(to.x - extent.x - 8 * look.scale, from.y + (size.y - extent.y) / 2),
                ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
  ImGui::Dummy(size);
}

}  // namespace aucast::gui
