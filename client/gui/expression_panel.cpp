#include <imgui.h>

#include <algorithm>
#include <array>

#include "client/gui/panels.h"

namespace aucast::gui {
namespace {

constexpr std::array kInterpolations = {"Linear", "Cosine"};
constexpr int kColumns = 4;

/// Returns how many there were.
int expression_buttons(const GuiModel& model, ExpressionKind kind, GuiCommands& commands) {
  int place = 0;
  for (std::size_t i = 0; i < model.expressions.size(); ++i) {
    const ExpressionButton& button = model.expressions[i];
    if (button.kind != kind) continue;
    ImGui::PushID(static_cast<int>(i));
    if (wide_button(button.label.c_str(), place++ % kColumns, kColumns, true)) {
      commands.push_back(ShowExpression{i});
    }
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", button.what.c_str());
    ImGui::PopID();
  }
  return place;
}

/// Other sets of AUs for the same emotions: what the buttons leave free of their last line.
void more_expressions(const GuiModel& model, int buttons, GuiCommands& commands) {
  if (buttons % kColumns != 0) ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##more", "more", ImGuiComboFlags_HeightLarge)) return;
  for (std::size_t i = 0; i < model.expressions.size(); ++i) {
    const ExpressionButton& button = model.expressions[i];
    if (button.kind != ExpressionKind::Other) continue;
    if (ImGui::Selectable(button.label.c_str())) commands.push_back(ShowExpression{i});
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", button.what.c_str());
  }
  ImGui::EndCombo();
}

void expressions(const Look& look, const GuiModel& model, GuiCommands& commands) {
  heading(look, "Expressions");
  more_expressions(model, expression_buttons(model, ExpressionKind::Main, commands), commands);
  heading(look, "Waters' macros");
  expression_buttons(model, ExpressionKind::Macro, commands);
}

void way_there(const Look& look, const GuiModel& model, GuiCommands& commands) {
  heading(look, "On the way there");
  TransitionSettings settings = model.transition;
  label(look, "In between");
  int kind = settings.cosine ? 1 : 0;
  bool changed = choice("way", kInterpolations, kind);
  settings.cosine = kind == 1;
  label(look, "Frames");
  if (ImGui::InputInt("##frames", &settings.frames, 1, 10)) {
    settings.frames = std::clamp(settings.frames, 1, 500);
    changed = true;
  }
  label(look, "Each in ms");
  if (ImGui::InputInt("##frame", &settings.frame_ms, 1, 10)) {
    settings.frame_ms = std::clamp(settings.frame_ms, 1, 1000);
    changed = true;
  }
  if (changed) commands.push_back(ChangeTransition{settings});
}

/// Several AUs at once, as mixer and rules make a face of them.
void compound(const Look& look, const GuiModel& model, ExpressionForm& form,
              GuiCommands& commands) {
  heading(look, "Action Units together");
  const float button = 70 * look.scale;
  ImGui::SetNextItemWidth(-(button + ImGui::GetStyle().ItemSpacing.x));
  const bool entered =
      ImGui::InputTextWithHint("##compound", "1,2,5B,L12:40", form.aus.data(), form.aus.size(),
                               ImGuiInputTextFlags_EnterReturnsTrue);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("AUs as in a packet; mixer and rules are applied");
  ImGui::SameLine();
  const bool pressed = ImGui::Button("Show", ImVec2(-1, 0));
  if ((pressed || entered) && form.aus[0] != 0) commands.push_back(ShowAus{form.aus.data()});
  if (!model.editor.compound.empty()) au_table(look, "asked", model.editor.compound);
}

}  // namespace

void expression_panel(const Look& look, const GuiModel& model, ExpressionForm& form,
                      GuiCommands& commands) {
  expressions(look, model, commands);
  way_there(look, model, commands);
  compound(look, model, form, commands);
}

}  // namespace aucast::gui
