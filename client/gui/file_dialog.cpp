#include <imgui.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "client/gui/panels.h"

namespace aucast::gui {
namespace {

const char* title_of(Purpose purpose) {
  switch (purpose) {
    case Purpose::PlayStream:
      return "Open a stream file or a recogniser's table";
    case Purpose::ComposeStream:
      return "Open a stream file to work on";
    case Purpose::SaveStream:
      return "Save the composed stream";
    case Purpose::ExportKeyframes:
      return "Export the keyframes played";
    case Purpose::ExportTable:
      return "Export the AUs played as a table";
    case Purpose::ExportMesh:
      return "Export this face as a mesh";
    case Purpose::ExportGlb:
      return "Export face and movement as glTF";
    case Purpose::ExportAu:
      return "Export the Action Unit";
    case Purpose::PictureFolder:
      return "The folder for pictures and videos";
    case Purpose::GalleryFolder:
      return "The folder for the gallery";
    case Purpose::LookForFaces:
      return "Open a folder with faces";
  }
  return "File";
}

template <std::size_t N>
void set_text(std::array<char, N>& out, const std::string& text) {
  const std::size_t length = std::min(text.size(), N - 1);
  std::memcpy(out.data(), text.data(), length);
  out[length] = 0;
}

void folder_line(const Look& look, const BrowserView& view, FileForm& form, GuiCommands& commands) {
  const float up = 60 * look.scale;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - up - ImGui::GetStyle().ItemSpacing.x);
  if (ImGui::InputText("##folder", form.folder.data(), form.folder.size(),
                       ImGuiInputTextFlags_EnterReturnsTrue)) {
    commands.push_back(ChooseFile{form.folder.data()});
  }
  ImGui::SameLine();
  const auto parent = std::filesystem::path(view.folder).parent_path();
  if (ImGui::Button("Up", ImVec2(up, 0))) commands.push_back(EnterFolder{parent.string()});
}

/// One click chooses a file; a second one on it takes it. A folder opens at the first.
void entry_list(const Look& look, const BrowserView& view, FileForm& form, float height,
                GuiCommands& commands) {
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(8 * look.scale, 6 * look.scale));
  if (ImGui::BeginChild("entries", ImVec2(0, height), false,
                        ImGuiWindowFlags_AlwaysUseWindowPadding)) {
    for (const FileEntry& entry : view.entries) {
      const bool chosen = !entry.folder && entry.name == form.name.data();
      const std::string shown = entry.folder ? entry.name + "/" : entry.name;
      ImGui::PushStyleColor(ImGuiCol_Text, entry.folder ? ImGui::GetColorU32(ImGuiCol_PlotLines)
                                                        : ImGui::GetColorU32(ImGuiCol_Text));
      const bool clicked =
          ImGui::Selectable(shown.c_str(), chosen, ImGuiSelectableFlags_AllowDoubleClick);
      ImGui::PopStyleColor();
      if (!clicked) continue;
      if (entry.folder) {
        commands.push_back(EnterFolder{entry.name});
      } else {
        set_text(form.name, entry.name);
        if (ImGui::IsMouseDoubleClicked(0)) commands.push_back(ChooseFile{entry.name});
      }
    }
    if (view.entries.empty()) ImGui::TextDisabled("Nothing here.");
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
}

/// Why it was not done; empty: nothing is wrong.
std::string objection(const BrowserView& view) {
  if (!view.problem.empty()) return view.problem;
  return view.replaces.empty() ? std::string() : view.replaces + " is there already.";
}

/// What decide() takes: the buttons stay where they are when there is an objection.
float height_of_decision(const BrowserView& view) {
  const float gap = ImGui::GetStyle().ItemSpacing.y;
  float height = ImGui::GetFrameHeight() + gap;
  if (is_saving(view.purpose)) height += ImGui::GetFrameHeight() + gap;
  const std::string text = objection(view);
  if (text.empty()) return height;
  const float width = ImGui::GetContentRegionAvail().x;
  return height + ImGui::CalcTextSize(text.c_str(), nullptr, false, width).y + gap;
}

/// What a recogniser's table may need to be told; closed until somebody looks for it.
void table_settings(const Look& look, const TableSettings& now, GuiCommands& commands) {
  if (!ImGui::TreeNodeEx("Tables of recognisers",
                         ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen)) {
    return;
  }
  TableSettings settings = now;
  bool changed = false;
  const auto number = [&](const char* name, const char* id, int& value, int most, int step,
                          const char* tip) {
    label(look, name);
    changed |= ImGui::InputInt(id, &value, step, 10 * step);
    value = std::clamp(value, 0, most);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tip);
  };
  number("Pictures/s", "##fps", settings.fps, 1000, 1,
         "of the video, for a table without times (--fps); 0: the table's own times");
  number("Keyframes/s", "##rate", settings.rate, 100, 1, "0: one for each row");
  number("Gain %", "##gain", settings.gain_percent, 1000, 10, "of all AUs; 0: as they are");
  number("Quiet, s", "##quiet", settings.quiet_s, 60, 1,
         "the face is quiet for so long at first, and what it shows then is taken off; 0: none");
  if (changed) commands.push_back(ChangeTable{settings});
}

void decide(const Look& look, const BrowserView& view, FileForm& form, GuiCommands& commands) {
  const bool saving = is_saving(view.purpose);
  bool entered = false;
  if (saving) {
    label(look, "Name");
    entered = ImGui::InputText("##name", form.name.data(), form.name.size(),
                               ImGuiInputTextFlags_EnterReturnsTrue);
  }
  const std::string text = objection(view);
  if (!text.empty()) toned_text(view.problem.empty() ? Tone::Waiting : Tone::Bad, text);
  const bool folder = is_folder(view.purpose);
  const char* action = folder                  ? "This folder"
                       : !saving               ? "Open"
                       : view.replaces.empty() ? "Save"
                                               : "Replace it";
  const bool named = folder || form.name[0] != 0;
  if (wide_button("Cancel", 0, 2, true)) commands.push_back(CloseBrowser{});
  const bool pressed = wide_button(action, 1, 2, named, named);
  if (named && (pressed || entered)) {
    commands.push_back(ChooseFile{folder ? "." : form.name.data()});
  }
}

}  // namespace

void file_dialog(const Look& look, const GuiModel& model, FileForm& form, GuiCommands& commands) {
  const BrowserView& view = model.browser;
  constexpr const char* kId = "###files";
  if (!view.open) {
    form.shown_folder.clear();
    return;
  }
  if (form.shown_folder.empty() || form.shown_name != view.name) {
    form.shown_name = view.name;
    set_text(form.name, view.name);
  }
  if (form.shown_folder != view.folder) {
    form.shown_folder = view.folder;
    set_text(form.folder, view.folder);
    if (!is_saving(view.purpose)) form.name[0] = 0;
  }
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float width = std::min(560 * look.scale, screen.x - 20);
  const float height = std::min(520 * look.scale, screen.y - 20);
  ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y / 2), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  ImGui::SetNextWindowSize(ImVec2(width, height));
  if (!ImGui::IsPopupOpen(kId)) ImGui::OpenPopup(kId);
  const std::string title = std::string(title_of(view.purpose)) + kId;
  bool shown = true;
  constexpr ImGuiWindowFlags kFlags =
      ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
  const FloatingStyle floating(look);
  if (!ImGui::BeginPopupModal(title.c_str(), &shown, kFlags)) {
    commands.push_back(CloseBrowser{});
    return;
  }
  folder_line(look, view, form, commands);
  if (view.purpose == Purpose::PlayStream) table_settings(look, model.table, commands);
  const float below = height_of_decision(view);
  entry_list(look, view, form, std::max(ImGui::GetContentRegionAvail().y - below, 60.0F), commands);
  decide(look, view, form, commands);
  const bool escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (!shown || escaped) commands.push_back(CloseBrowser{});
  ImGui::EndPopup();
}

}  // namespace aucast::gui
