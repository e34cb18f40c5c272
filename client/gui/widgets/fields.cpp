#include "client/gui/widgets/fields.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "client/gui/texts/texts.h"
#include "client/gui/widgets/keyboard_focus.h"
#include "client/gui/widgets/tips.h"
#include "common/text.h"

namespace aucast::gui {
namespace {

constexpr float kChooseWidth = 70;

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
  const ItemsAre sliders(ItemsAre::Sliders);
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
  const ItemsAre buttons(ItemsAre::MouseOnly);  // the keyboard steps in what it belongs to
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

bool number_row(const Look& look, const char* name, const char* id, int& value, const Steps& steps,
                const char* help) {
  label(look, name, help);
  const bool changed = number_field(id, value, steps);
  tip(help);
  return changed;
}

bool belongs_to_drag() {
  return !ImGui::IsItemActivated() && ImGui::IsMouseDown(0) &&
         ImGui::GetIO().MouseDownDuration[0] > 0;
}

void set_text(std::span<char> field, std::string_view text) {
  field[text.copy(field.data(), field.size() - 1)] = 0;
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
