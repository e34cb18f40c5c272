#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "client/gui/model/expression_search.h"
#include "client/gui/panels/panels.h"
#include "client/gui/texts/texts.h"
#include "client/gui/widgets/au_table.h"
#include "client/gui/widgets/fields.h"
#include "client/gui/widgets/keyboard_focus.h"
#include "client/gui/widgets/tips.h"
#include "common/text.h"

namespace aucast::gui {
namespace {

constexpr int kColumns = 4;

/// How many fit side by side, in equal columns with room for the longest.
int columns_of(const ExpressionsView& expressions) {
  const ImGuiStyle& style = ImGui::GetStyle();
  float longest = 0;
  for (const ExpressionButton& button : expressions.buttons) {
    if (button.kind == ExpressionKind::Other) continue;
    longest = std::max(longest, ImGui::CalcTextSize(data_word(button.label).c_str()).x);
  }
  const float each = longest + style.FramePadding.x + style.ItemSpacing.x;
  const float width = ImGui::GetContentRegionAvail().x + style.ItemSpacing.x;
  return std::clamp(static_cast<int>(width / each), 1, kColumns);
}

/// Draws the buttons of this kind and returns how many there were.
int expression_buttons(const ExpressionsView& expressions, ExpressionKind kind,
                       GuiCommands& commands) {
  int place = 0;
  const int columns = columns_of(expressions);
  for (std::size_t i = 0; i < expressions.buttons.size(); ++i) {
    const ExpressionButton& button = expressions.buttons[i];
    if (button.kind != kind) continue;
    const bool chosen = static_cast<int>(i) == expressions.chosen;
    ImGui::PushID(static_cast<int>(i));
    if (wide_button(data_word(button.label).c_str(), place++ % columns, columns, true, chosen)) {
      commands.push_back(ShowExpression{i});
    }
    tip(in_words(button));
    ImGui::PopID();
  }
  return place;
}

/// Tells an expression from others of its label.
std::string whole_label(const ExpressionButton& button) {
  return data_word(button.label) + "  " + button.aus;
}

/// Each a line: label, AUs, source. `entered`: the first one is wanted.
void found_expressions(const ExpressionsView& expressions, const std::string& words, bool entered,
                       GuiCommands& commands) {
  bool any = false;
  float source_at = 0;
  for (const ExpressionButton& button : expressions.buttons) {
    if (button.kind != ExpressionKind::Other) continue;
    source_at = std::max(source_at, ImGui::CalcTextSize(whole_label(button).c_str()).x);
  }
  source_at += ImGui::GetCursorPosX() + 2 * ImGui::GetStyle().ItemSpacing.x;
  for (std::size_t i = 0; i < expressions.buttons.size(); ++i) {
    const ExpressionButton& button = expressions.buttons[i];
    if (button.kind != ExpressionKind::Other || !is_meant(button, words)) continue;
    const bool first = !std::exchange(any, true);
    const bool chosen = static_cast<int>(i) == expressions.chosen;
    ImGui::PushID(static_cast<int>(i));
    if (list_item(whole_label(button), chosen) || (first && entered)) {
      commands.push_back(ShowExpression{i});
      ImGui::CloseCurrentPopup();
    }
    ImGui::SameLine(source_at);
    ImGui::TextDisabled("%s", button.source.c_str());
    ImGui::PopID();
  }
  if (!any) quiet_text(tr("expression.none_found"));
}

/// Other sets of AUs for the same emotions: what the buttons leave free of their last line.
void more_expressions(const Look& look, const ExpressionsView& expressions, int buttons,
                      ExpressionForm& form, GuiCommands& commands) {
  const auto chosen = static_cast<std::size_t>(expressions.chosen);
  const bool is_other = chosen < expressions.buttons.size() &&
                        expressions.buttons[chosen].kind == ExpressionKind::Other;
  if (buttons % columns_of(expressions) != 0 && has_room_beside(70 * look.scale)) ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  const std::string shown =
      is_other ? whole_label(expressions.buttons[chosen]) : tr("expression.more");
  if (!ImGui::BeginCombo("##more", shown.c_str(), ImGuiComboFlags_HeightLarge)) {
    return tip(tr("tip.more"));
  }
  if (ImGui::IsWindowAppearing()) {
    form.search[0] = 0;
    ImGui::SetKeyboardFocusHere();
  }
  ImGui::SetNextItemWidth(260 * look.scale);
  const bool entered =
      ImGui::InputTextWithHint("##search", tr("expression.search_hint"), form.search.data(),
                               form.search.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  stay_in_field();
  const std::string words = lowered(form.search.data());
  found_expressions(expressions, words, entered && !words.empty(), commands);
  ImGui::EndCombo();
}

void strength(const Look& look, const ExpressionsView& expressions, GuiCommands& commands) {
  label(look, tr("expression.strength"), tr("expression.strength_tip"));
  int percent = expressions.percent;
  if (percent_slider("##strength", -1, percent)) {
    commands.push_back(ChangeStrength{percent, belongs_to_drag()});
  }
  tip(tr("expression.strength_tip"));
}

void expressions(const Look& look, const GuiModel& model, ExpressionForm& form,
                 GuiCommands& commands) {
  const ExpressionsView& all = model.expressions;
  heading(look, tr("expression.title"), tr("tip.expressions"));
  const int buttons = expression_buttons(all, ExpressionKind::Main, commands);
  more_expressions(look, all, buttons, form, commands);
  strength(look, all, commands);
  heading(look, tr("expression.macros"), tr("tip.macros"));
  expression_buttons(all, ExpressionKind::Macro, commands);
}

void way_there(const Look& look, const GuiModel& model, GuiCommands& commands) {
  heading(look, tr("expression.way"), tr("tip.way"));
  TransitionSettings settings = model.transition;
  using playback::Interpolation;
  auto way = settings.cosine ? Interpolation::Cosine : Interpolation::Linear;
  bool changed = in_between(look, "way", way);
  settings.cosine = way == Interpolation::Cosine;
  changed |= number_row(look, tr("expression.frames"), "##frames", settings.frames,
                        {.least = 1, .most = TransitionSettings::kFramesMax}, tr("tip.frames"));
  changed |= number_row(look, tr("expression.each_ms"), "##frame", settings.frame_ms,
                        {.least = 1, .most = TransitionSettings::kFrameMsMax}, tr("tip.frames"));
  quiet_text(tr("expression.takes", settings.frames * settings.frame_ms));
  if (changed) commands.push_back(ChangeTransition{settings});
}

/// Several AUs at once, after rules and mixer.
void compound(const Look& look, const GuiModel& model, ExpressionForm& form,
              GuiCommands& commands) {
  heading(look, tr("expression.together"), tr("tip.au"));
  // The AUs of an expression are where they can be changed; one that is made of muscles has none.
  const ExpressionsView& all = model.expressions;
  const int chosen = std::exchange(form.chosen, all.chosen);
  const bool other = chosen != all.chosen && all.chosen >= 0;
  if (std::exchange(form.taken, all.aus) != all.aus || other) {
    if (!all.aus.empty() || other) set_text(form.aus, all.aus);
  }
  const float button = 70 * look.scale;
  ImGui::SetNextItemWidth(-(button + ImGui::GetStyle().ItemSpacing.x));
  const bool entered = ImGui::InputTextWithHint(
      "##compound", "1,2,5B,L12:40", form.aus.data(), form.aus.size(),
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  stay_in_field();
  tip(tr("expression.together_tip"));
  ImGui::SameLine();
  const bool pressed = ImGui::Button(tr("button.show"), ImVec2(-1, 0));
  tip(tr("tip.show_aus"));
  if ((pressed || entered) && form.aus[0] != 0) commands.push_back(ShowAus{form.aus.data()});
  if (!model.editor.compound.empty()) {
    au_table(
        look,
        {tr("expression.asked"), tr("tip.au_asked"), tr("expression.legend"), tr("tip.au_blended")},
        model.editor.compound);
  }
}

}  // namespace

void expression_panel(const Look& look, const GuiModel& model, ExpressionForm& form,
                      GuiCommands& commands) {
  expressions(look, model, form, commands);
  way_there(look, model, commands);
  compound(look, model, form, commands);
}

}  // namespace aucast::gui
