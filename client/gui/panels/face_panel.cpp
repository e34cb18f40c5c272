#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <string>
#include <vector>

#include "client/gui/model/face_names.h"
#include "client/gui/panels/panels.h"
#include "client/gui/texts/said_text.h"
#include "client/gui/texts/texts.h"
#include "client/gui/widgets/fields.h"
#include "client/gui/widgets/keyboard_focus.h"
#include "client/gui/widgets/tips.h"

namespace aucast::gui {
namespace {

constexpr int kFacesInARow = 3;
/// Height of a thumbnail by its width.
constexpr float kShape = static_cast<float>(kFaceHeight) / kFaceWidth;

const char* heading_of(FaceKind kind) {
  switch (kind) {
    case FaceKind::Shipped:
      return tr("face.shipped");
    case FaceKind::Own:
      return tr("face.own");
    case FaceKind::Elsewhere:
      return tr("face.folder");
  }
  return "";
}

/// Writes as much of the name as fits, centred below the picture.
void name_below(const Look& look, const std::string& name, ImVec2 at, float width) {
  const ImVec2 size = ImGui::CalcTextSize(name.c_str());
  const float left = at.x + std::max(0.0F, (width - size.x) / 2);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(at, ImVec2(at.x + width, at.y + size.y + look.scale), true);
  list.AddText(ImVec2(left, at.y), ImGui::GetColorU32(ImGuiCol_Text), name.c_str());
  list.PopClipRect();
}

/// The name below its picture. A copy that was made for an edited face has the name of that face.
std::string name_among(const std::vector<FaceEntry>& faces, const FaceEntry& face) {
  const bool alike = face.kind == FaceKind::Own &&
                     std::any_of(faces.begin(), faces.end(), [&](const FaceEntry& other) {
                       return other.kind == FaceKind::Shipped && other.name == face.name;
                     });
  return alike ? tr("face.yours", face.name) : face.name;
}

/// A picture with its name; returns whether it was chosen.
bool face_tile(const Look& look, const FaceEntry& face, const std::string& name, bool shown,
               float width, Thumbnails& pictures) {
  const float height = width * kShape;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 to(at.x + width, at.y + height);
  const float rounding = ImGui::GetStyle().FrameRounding;
  const bool chosen = ImGui::InvisibleButton(
      face.folder.c_str(), ImVec2(width, height + ImGui::GetTextLineHeightWithSpacing()));
  mark_focus();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (ImGui::IsItemVisible()) draw_thumbnail(pictures, face.folder, at, to);
  const auto wrong = pictures.wrong.find(face.folder);
  const bool unreadable = wrong != pictures.wrong.end();
  if (unreadable) {
    const char* text = tr("face.unreadable");
    const float left = std::max(0.0F, (width - ImGui::CalcTextSize(text).x) / 2);
    list.AddText(ImVec2(at.x + left, at.y + height / 2), colour_of(Tone::Bad), text);
  }
  const ImGuiCol frame = shown ? ImGuiCol_PlotLinesHovered : ImGuiCol_Border;
  if (shown || ImGui::IsItemHovered()) {
    list.AddRect(at, to, ImGui::GetColorU32(frame), rounding, 0,
                 (shown ? 2.0F : 1.0F) * look.scale);
  }
  name_below(look, name, ImVec2(at.x, to.y + 2 * look.scale), width);
  std::string about = ImGui::CalcTextSize(name.c_str()).x > width ? name + "\n" : std::string();
  if (unreadable || face.kind != FaceKind::Shipped) about += face.folder;
  if (unreadable) about += "\n" + in_used_language(wrong->second);
  tip(about);
  return chosen;
}

/// What is done with the face that is shown.
void own_face_buttons(const FacesView& faces, FaceForm& form) {
  const FaceEntry* face = shown_face(faces);
  const bool own = face != nullptr && face->kind == FaceKind::Own;
  const auto button = [&](TextKey text, int share, bool enabled, const char* help,
                          FaceForm::Asks asks) {
    if (wide_button(tr(text), share, 3, enabled)) {
      form.asks = asks;
      form.folder = face->folder;
      const auto taken = [&](const std::string& name) { return is_face_name(name, faces); };
      const std::string name =
          asks == FaceForm::Asks::Copy ? name_for_copy(face->name, taken) : face->name;
      set_text(form.name, name);
    }
    tip(help, true);
  };
  button("face.copy", 0, face != nullptr, tr("face.copy_tip"), FaceForm::Asks::Copy);
  button("face.rename", 1, own, own ? tr("face.rename_tip") : tr("face.not_own_tip"),
         FaceForm::Asks::Rename);
  button("face.delete", 2, own, own ? tr("face.delete_tip") : tr("face.not_own_tip"),
         FaceForm::Asks::Delete);
}

}  // namespace

void face_part(const Look& look, const GuiModel& model, FaceForm& form, GuiCommands& commands) {
  heading(look, tr("face.title"));
  const FacesView& faces = model.faces;
  if (faces.entries == nullptr) return;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float room = ImGui::GetContentRegionAvail().x;
  const float width = (room - (kFacesInARow - 1) * gap) / kFacesInARow;
  int in_row = 0;
  const FaceEntry* before = nullptr;
  for (const FaceEntry& face : *faces.entries) {
    const bool first = before == nullptr || before->kind != face.kind;
    if (first) quiet_text(heading_of(face.kind));
    if (first && face.kind == FaceKind::Elsewhere) tip(faces.elsewhere);
    in_row = first ? 0 : (in_row + 1) % kFacesInARow;
    if (in_row > 0) ImGui::SameLine(0, gap);
    const bool shown = face.folder == faces.shown;
    if (face_tile(look, face, name_among(*faces.entries, face), shown, width, form.pictures) &&
        !shown)
      commands.push_back(ShowFace{face.folder});
    before = &face;
  }
  own_face_buttons(faces, form);
  if (wide_button(tr("face.other"), 0, 1, true)) {
    commands.push_back(Browse{Purpose::LookForFaces});
  }
  tip(tr("tip.other_face"));
}

}  // namespace aucast::gui
