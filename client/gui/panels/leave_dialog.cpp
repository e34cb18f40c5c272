#include <imgui.h>

#include <algorithm>
#include <string>

#include "client/gui/panels/panels.h"
#include "client/gui/texts/texts.h"
#include "client/gui/widgets/tips.h"
#include "client/gui/widgets/widgets.h"

namespace aucast::gui {
namespace {

/// What would be lost.
std::string lost_in_words(const GuiModel& model) {
  std::string text;
  if (model.editor.unsaved) {
    text = model.editor.au >= 0 ? tr("leave.au", model.editor.au)
                                : std::string(tr("leave.expression"));
  }
  const auto add = [&text](const std::string& line) { text += (text.empty() ? "" : "\n") + line; };
  if (model.composer.unsaved) add(tr("leave.stream"));
  if (model.composer.begun) add(tr("leave.keyframe"));
  if (model.gallery.running) add(tr("leave.gallery", model.gallery.settings.folder));
  if (!model.exported.file.empty()) add(tr("leave.export", model.exported.file));
  return text;
}

/// Why something in the editor would stay unsaved if the AU that is edited were saved; empty:
/// nothing would. An expression that is no AU has no place to go to, and a name is saved with its
/// AU.
std::string why_not_saved(const EditorView& editor) {
  if (!editor.unsaved) return "";
  if (editor.au < 1) return tr("leave.no_number");
  const bool others = std::any_of(editor.names.begin(), editor.names.end(),
                                  [&](const auto& name) { return name.first != editor.au; });
  return others ? tr("leave.other_names") : "";
}

/// To stay comes first, and is what Enter does.
void leave_buttons(const GuiModel& model, float room, const char* leave, GuiCommands& commands) {
  const bool unsaved = model.editor.unsaved || model.composer.unsaved;
  const auto answer = [&commands](const Leave& one) {
    commands.push_back(one);
    ImGui::CloseCurrentPopup();
  };
  const int shares = unsaved ? 3 : 2;
  // So wide that all are in one row, if the screen has the room.
  float widest = 0;
  for (const char* text : {tr("leave.stay"), tr("button.save"), leave}) {
    widest = std::max(widest, ImGui::CalcTextSize(text).x);
  }
  const ImGuiStyle& style = ImGui::GetStyle();
  const float each = widest + 2 * style.FramePadding.x + style.ItemSpacing.x;
  ImGui::Dummy(ImVec2(std::min(room, static_cast<float>(shares) * each), 0));
  // The key that asked is not an answer.
  const bool escaped = !ImGui::IsWindowAppearing() &&
                       ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
  if (wide_button(tr("leave.stay"), 0, shares, true, true) || escaped) answer(Leave{false});
  if (unsaved) {
    const std::string why_not = why_not_saved(model.editor);
    if (wide_button(tr("button.save"), 1, shares, why_not.empty())) {
      answer({.really = false, .saves = true});
    }
    tip(why_not, true);
  }
  if (wide_button(leave, shares - 1, shares, true)) answer(Leave{true});
}

}  // namespace

void leave_dialog(const Look& look, const GuiModel& model, GuiCommands& commands) {
  const bool unsaved = model.editor.unsaved || model.composer.unsaved;
  const char* const leave = unsaved ? tr("leave.leave") : tr("leave.at_once");
  const std::string whole_title =
      with_id(unsaved ? tr("leave.title") : tr("leave.title_working"), "leave");
  const char* const title = whole_title.c_str();
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(size.x / 2, size.y / 2), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  const FloatingStyle floating(look);
  if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
  const std::string why = lost_in_words(model);
  const ImGuiStyle& style = ImGui::GetStyle();
  const float room = size.x - 4 * style.WindowPadding.x;
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() +
                         std::min(room, ImGui::CalcTextSize(why.c_str()).x + 1));
  ImGui::TextUnformatted(why.c_str());
  ImGui::PopTextWrapPos();
  leave_buttons(model, room, leave, commands);
  ImGui::EndPopup();
}

}  // namespace aucast::gui
