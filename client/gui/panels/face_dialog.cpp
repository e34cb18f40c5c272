#include <imgui.h>

#include <algorithm>
#include <string>

#include "client/gui/model/face_names.h"
#include "client/gui/panels/panels.h"
#include "client/gui/texts/texts.h"
#include "client/gui/widgets/keyboard_focus.h"
#include "common/text_file.h"

namespace aucast::gui {
namespace {

using Asked = FaceForm::Asks;

constexpr float kQuestionWidth = 400;

std::string title_of_question(Asked asks, const std::string& face) {
  switch (asks) {
    case Asked::Copy:
      return tr("face.copy_title", face);
    case Asked::Rename:
      return tr("face.rename_title", face);
    case Asked::Delete:
    case Asked::Nothing:
      break;
  }
  return tr("face.delete_title", face);
}

/// The field for the name and what is wrong with it. Returns whether Enter was pressed in it.
bool face_name_field(const Look& look, FaceForm& form, const std::string& wrong) {
  label(look, tr("file.name"), tr("tip.face_name"));
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const bool entered =
      ImGui::InputText("##facename", form.name.data(), form.name.size(),
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  stay_in_field();  // to be corrected, if it is wrong
  // Always a line, so that no button moves.
  if (wrong.empty()) {
    quiet_text(" ");
  } else {
    toned_text(Tone::Waiting, wrong);
  }
  return entered;
}

void ask_name(const Look& look, const FacesView& faces, const FaceEntry& face, FaceForm& form,
              GuiCommands& commands) {
  const std::string name(trimmed(form.name.data(), " "));
  const bool renames = form.asks == Asked::Rename;
  const bool same = renames && name == face.name;
  const std::string wrong = same ? "" : wrong_face_name(name, faces);
  const bool entered = face_name_field(look, form, wrong);
  const bool may = !same && wrong.empty();
  if (wide_button(tr("button.cancel"), 0, 2, true)) form.asks = Asked::Nothing;
  const char* action = renames ? tr("face.rename_button") : tr("face.copy_button");
  const bool pressed = wide_button(action, 1, 2, may, may);
  if (!may || !(pressed || entered)) return;
  form.asks = Asked::Nothing;
  if (renames) {
    commands.push_back(RenameFace{face.folder, name});
  } else {
    commands.push_back(CopyFace{face.folder, name});
  }
}

void ask_to_delete(const FaceEntry& face, FaceForm& form, GuiCommands& commands) {
  ImGui::TextWrapped("%s", face.target.empty()
                               ? tr("face.deleted_with", face.folder).c_str()
                               : tr("face.link_deleted", face.folder, face.target).c_str());
  ImGui::Spacing();
  if (wide_button(tr("button.cancel"), 0, 2, true)) form.asks = Asked::Nothing;
  if (!wide_button(tr("button.delete"), 1, 2, true)) return;
  form.asks = Asked::Nothing;
  commands.push_back(DeleteFace{face.folder});
}

}  // namespace

void face_dialog(const Look& look, const GuiModel& model, FaceForm& form, GuiCommands& commands) {
  constexpr const char* kId = "###face";
  if (form.asks == Asked::Nothing) return;
  const FaceEntry* face = listed_face(model.faces, form.folder);
  if (face == nullptr) {
    form.asks = Asked::Nothing;
    return;
  }
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y / 2), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  ImGui::SetNextWindowSize(ImVec2(std::min(kQuestionWidth * look.scale, screen.x - 20), 0));
  if (!ImGui::IsPopupOpen(kId)) ImGui::OpenPopup(kId);
  const std::string title = title_of_question(form.asks, face->name) + kId;
  bool shown = true;
  constexpr ImGuiWindowFlags kFlags =
      ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
  const FloatingStyle floating(look);
  if (!ImGui::BeginPopupModal(title.c_str(), &shown, kFlags)) {
    form.asks = Asked::Nothing;
    return;
  }
  if (form.asks == Asked::Delete) {
    ask_to_delete(*face, form, commands);
  } else {
    ask_name(look, model.faces, *face, form, commands);
  }
  const bool escaped = !ImGui::IsWindowAppearing() &&
                       ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
  if (escaped) form.asks = Asked::Nothing;
  if (form.asks == Asked::Nothing) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace aucast::gui
