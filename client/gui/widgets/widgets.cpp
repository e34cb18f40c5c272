#include "client/gui/widgets/widgets.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <system_error>

#include "client/gui/texts/texts.h"
#include "client/gui/widgets/kept_place.h"
#include "client/gui/widgets/keyboard_focus.h"
#include "client/gui/widgets/tips.h"
#include "common/text.h"

namespace aucast::gui {
namespace {

constexpr float kLabelWidth = 112;
constexpr float kChooseWidth = 70;
/// Room, in letters' heights, without which a control stands below its label, not beside it.
constexpr float kControlWidth = 7;

ImVec4 accent() {
  return ImGui::GetStyleColorVec4(ImGuiCol_PlotLines);
}

void percent(int value, bool differs) {
  if (value == 0) {
    ImGui::TextDisabled("-");
  } else if (differs) {
    toned_line(Tone::Waiting, std::to_string(value));
  } else {
    ImGui::Text("%d", value);
  }
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

void leave_room_to_choose(const Look& look) {
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - kChooseWidth * look.scale -
                          ImGui::GetStyle().ItemSpacing.x);
}

bool choose_button(const Look& look) {
  ImGui::SameLine();
  const bool pressed = ImGui::Button(tr("button.choose"), ImVec2(kChooseWidth * look.scale, 0));
  tip(tr("tip.choose"));
  return pressed;
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

bool belongs_to_drag() {
  return !ImGui::IsItemActivated() && ImGui::IsMouseDown(0) &&
         ImGui::GetIO().MouseDownDuration[0] > 0;
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

namespace {

/// Says that a typed number beyond the limits is clamped.
template <typename Number>
void say_if_outside(double typed, const std::array<Number, 2>& limits) {
  const auto least = static_cast<double>(limits[0]);
  const auto most = static_cast<double>(limits[1]);
  if (typed >= least && typed <= most) return;
  tip_of_last(tr("panel.outside", number_text(least), number_text(most),
                 number_text(std::clamp(typed, least, most))));
}

/// ImGui writes the number under the grip. Here it is beside the slider, and in it only while it is
/// typed.
template <typename Number>
bool slider_of(ImGuiDataType type, const char* id, float width, Number& value,
               const std::array<Number, 2>& limits, const char* format, const char* widest = "") {
  std::array<char, 32> text{};
  float column = ImGui::CalcTextSize(widest).x;
  const auto width_of = [&](Number number) {
    std::snprintf(text.data(), text.size(), format, number);
    return ImGui::CalcTextSize(text.data()).x;
  };
  for (const Number limit : limits) column = std::max(column, width_of(limit));
  column += ImGui::GetStyle().ItemInnerSpacing.x;
  const float whole = width < 0 ? ImGui::GetContentRegionAvail().x : width;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float end = at.x + whole - width_of(value);
  const ImVec2 number(end, at.y + ImGui::GetStyle().FramePadding.y);
  ImGui::GetWindowDrawList()->AddText(number, ImGui::GetColorU32(ImGuiCol_Text), text.data());
  const bool typed = ImGui::TempInputIsActive(ImGui::GetID(id));
  if (!typed) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0, 0, 0, 0));
  const SliderScope slider;
  ImGui::SetNextItemWidth(whole - column);
  const bool changed = ImGui::SliderScalar(id, type, &value, &limits[0], &limits[1], format,
                                           ImGuiSliderFlags_AlwaysClamp);
  if (!typed) ImGui::PopStyleColor();
  const ImGuiInputTextState* const text_typed =
      typed ? ImGui::GetInputTextState(ImGui::GetID(id)) : nullptr;
  if (text_typed != nullptr && text_typed->TextAIsValid && text_typed->TextA[0] != 0) {
    say_if_outside(std::strtod(text_typed->TextA.Data, nullptr), limits);
  }
  // What comes next on this line comes behind the number.
  ImGui::GetCurrentWindow()->DC.CursorPosPrevLine.x += column;
  return changed;
}

/// The number, if the text is nothing but a whole number.
std::optional<int> whole_number(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

struct Stepped {
  const Steps& steps;
  int value = 0;
};

int step_on(const Steps& steps, int value, int direction) {
  if (value == 0 && direction > 0 && steps.first > 0) return steps.first;
  const int by = ImGui::GetIO().KeyCtrl ? steps.far : steps.near;
  return std::clamp(value + direction * by, steps.least, steps.most);
}

/// Handles Up and Down while the number is typed.
int step_typed(ImGuiInputTextCallbackData* typed) {
  const auto& stepped = *static_cast<const Stepped*>(typed->UserData);
  const auto there = static_cast<std::size_t>(typed->BufTextLen);
  const int value = whole_number({typed->Buf, there}).value_or(stepped.value);
  const int direction = typed->EventKey == ImGuiKey_UpArrow ? 1 : -1;
  typed->DeleteChars(0, typed->BufTextLen);
  typed->InsertChars(0, std::to_string(step_on(stepped.steps, value, direction)).c_str());
  typed->SelectAll();
  return 0;
}

}  // namespace

bool slider(const char* id, float width, int& value, int least, int most, const char* format,
            const char* column) {
  return slider_of<int>(ImGuiDataType_S32, id, width, value, {least, most}, format, column);
}

bool slider(const char* id, float width, float& value, float least, float most,
            const char* format) {
  return slider_of<float>(ImGuiDataType_Float, id, width, value, {least, most}, format);
}

bool percent_slider(const char* id, float width, int& value) {
  return slider(id, width, value, 0, 100, "%d %%");
}

bool step_button(const char* text, const ImVec2& size, ImGuiID owner) {
  const MouseOnly mouse;  // the keyboard steps in what it belongs to
  ImGui::PushButtonRepeat(true);
  const bool pressed = ImGui::Button(text, size);
  ImGui::PopButtonRepeat();
  if (pressed) ImGui::SetFocusID(owner, ImGui::GetCurrentWindow());
  return pressed;
}

float number_field_width() {
  const float button = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
  return std::ceil(2 * button + 2.5F * ImGui::GetFontSize());  // ImGui's widths are whole
}

bool number_field(const char* id, int& value, const Steps& steps, bool when_entered) {
  const float button = ImGui::GetFrameHeight();
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width = ImGui::CalcItemWidth();
  const bool buttons = steps.buttons && width >= number_field_width();
  std::array<char, 16> text{};
  const bool in_words = steps.zero != nullptr && value == 0;
  if (!in_words) std::snprintf(text.data(), text.size(), "%d", value);
  Stepped stepped{steps, value};
  ImGuiInputTextFlags flags = ImGuiInputTextFlags_CharsDecimal | ImGuiInputTextFlags_AutoSelectAll |
                              ImGuiInputTextFlags_CallbackHistory;
  if (when_entered) flags |= ImGuiInputTextFlags_EnterReturnsTrue;
  ImGui::BeginGroup();
  ImGui::PushID(id);
  ImGui::SetNextItemWidth(buttons ? width - 2 * (button + gap) : width);
  const int before = value;
  const char* const hint = steps.zero == nullptr ? "" : steps.zero;
  if (ImGui::InputTextWithHint("", hint, text.data(), text.size(), flags, step_typed, &stepped)) {
    const bool emptied = text[0] == 0 && steps.zero != nullptr;
    const int typed = emptied ? 0 : whole_number(text.data()).value_or(value);
    value = std::clamp(typed, steps.least, steps.most);
  }
  if (ImGui::IsItemActive() && !(text[0] == 0)) {
    say_if_outside<int>(std::strtod(text.data(), nullptr), {steps.least, steps.most});
  }
  const ImGuiID field = ImGui::GetItemID();
  for (const int direction : {-1, 1}) {
    if (!buttons) break;
    ImGui::SameLine(0, gap);
    if (step_button(direction < 0 ? "-" : "+", ImVec2(button, button), field)) {
      value = step_on(steps, value, direction);
    }
  }
  ImGui::PopID();
  ImGui::EndGroup();
  return value != before;
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

void au_table(const Look& look, const AuTableWords& words, const std::vector<AuRow>& rows) {
  quiet_text(words.legend);
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg;
  if (!ImGui::BeginTable("aus", 4, kFlags)) return;
  ImGui::TableSetupColumn(tr("panel.au"), 0, 34 * look.scale);
  ImGui::TableSetupColumn(tr("panel.au_name"), ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn(words.given, 0, 58 * look.scale);
  ImGui::TableSetupColumn(tr("panel.shown"), 0, 46 * look.scale);
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  const std::array<const char*, 4> tips = {tr("tip.au"), "", words.given_tip, words.shown_tip};
  for (int column = 0; column < 4; ++column) {
    ImGui::TableSetColumnIndex(column);
    ImGui::TableHeader(ImGui::TableGetColumnName(column));
    tip(tips[static_cast<std::size_t>(column)]);
  }
  for (const AuRow& row : rows) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    mark_row(row.label);
    const bool idle = row.received_percent + row.shown_percent == 0;
    if (idle) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextUnformatted(row.label.c_str());
    ImGui::TableNextColumn();
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    const bool cut = ImGui::CalcTextSize(row.name.c_str()).x > ImGui::GetContentRegionAvail().x;
    fitted_text(row.name, right);
    if (idle) ImGui::PopStyleColor();
    if (cut) tip(row.name);
    if (!row.why.empty()) {
      quiet_text(row.why);
      tip(tr("tip.rule"));
    } else if (row.room_for_why) {
      ImGui::NewLine();
    }
    ImGui::TableNextColumn();
    percent(row.received_percent, false);
    ImGui::TableNextColumn();
    percent(row.shown_percent, !row.why.empty());
    if (row.received_percent != row.shown_percent) tip(words.shown_tip);
  }
  ImGui::EndTable();
}

bool choice(const char* id, std::span<const Word> words, int& chosen) {
  ImGui::PushID(id);
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const int count = static_cast<int>(words.size());
  // What is left beside the words is shared evenly, so that a long one has room.
  float left = ImGui::GetContentRegionAvail().x - gap * static_cast<float>(count - 1);
  for (const Word& word : words) left -= ImGui::CalcTextSize(word.text).x;
  const float around = left / static_cast<float>(count);
  bool changed = false;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      ImVec2(gap / 2, ImGui::GetStyle().FramePadding.y));
  for (int i = 0; i < count; ++i) {
    const Word& word = words[static_cast<std::size_t>(i)];
    if (i > 0) ImGui::SameLine(0, gap);
    const bool on = i == chosen;
    // What is chosen looks so under the pointer too.
    if (on) {
      ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_Header));
      ImGui::PushStyleColor(ImGuiCol_ButtonHovered,
                            ImGui::GetStyleColorVec4(ImGuiCol_HeaderHovered));
      ImGui::PushStyleColor(ImGuiCol_ButtonActive, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
    }
    if (ImGui::Button(word.text, ImVec2(ImGui::CalcTextSize(word.text).x + around, 0)) && !on) {
      chosen = i;
      changed = true;
    }
    if (on) ImGui::PopStyleColor(3);
    tip(word.tip);
  }
  ImGui::PopStyleVar();
  ImGui::PopID();
  return changed;
}

bool in_between(const Look& look, const char* id, playback::Interpolation& way) {
  const std::array<Word, 2> ways = {
      {{tr("panel.linear"), tr("tip.linear")}, {tr("panel.cosine"), tr("tip.cosine")}}};
  label(look, tr("panel.in_between"), tr("tip.in_between"));
  int chosen = way == playback::Interpolation::Cosine ? 1 : 0;
  if (!choice(id, ways, chosen)) return false;
  way = chosen == 1 ? playback::Interpolation::Cosine : playback::Interpolation::Linear;
  return true;
}

}  // namespace aucast::gui
