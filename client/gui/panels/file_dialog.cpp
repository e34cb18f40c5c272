#include <imgui.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "client/gui/model/view_text.h"
#include "client/gui/panels/panels.h"
#include "client/gui/texts/texts.h"
#include "client/gui/widgets/fields.h"
#include "client/gui/widgets/keyboard_focus.h"
#include "client/gui/widgets/tips.h"

namespace aucast::gui {
namespace {

constexpr float kUpWidth = 60;

/// The titles, in the order of Purpose.
constexpr std::array<TextKey, 16> kTitles{
    "file.play",         "file.compose",     "file.save_stream",    "file.export_keyframes",
    "file.export_table", "file.export_mesh", "file.export_glb",     "file.onsets",
    "file.export_au",    "file.import_aus",  "file.picture_folder", "file.gallery_folder",
    "file.faces",        "file.film",        "file.authorities",    "file.token"};

const char* title_of(Purpose purpose) {
  static_assert(kTitles.size() == static_cast<std::size_t>(Purpose::TokenFile) + 1);
  return tr(kTitles[static_cast<std::size_t>(purpose)]);
}

/// Whether the line of the folder has another path in it, which was typed.
bool path_is_typed(const BrowserView& view, const FileForm& form) {
  return form.folder.data() != view.folder;
}

/// Backspace does the same where nothing is being typed.
void up_button(const Look& look, const BrowserView& view, GuiCommands& commands) {
  const bool backspace =
      !ImGui::IsAnyItemActive() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Backspace));
  const bool pressed = ImGui::Button(tr("file.up"), ImVec2(kUpWidth * look.scale, 0));
  tip(tr("tip.folder_up"));
  if (!pressed && !backspace) return;
  commands.push_back(EnterFolder{std::filesystem::path(view.folder).parent_path().string()});
}

/// Whether a path is begun where nothing is being typed: it is for the line of the folder, and what
/// has been typed of it is put there.
bool path_begins(const BrowserView& view, FileForm& form) {
  auto& typed = ImGui::GetIO().InputQueueCharacters;
  const bool begins = !typed.empty() && (typed[0] == '/' || typed[0] == '~');
  if (!begins || is_saving(view.purpose) || ImGui::IsAnyItemActive()) return false;
  set_text(form.folder, typed_text());
  typed.clear();
  form.name[0] = 0;
  form.to_first = false;
  enter_field("##folder");
  return true;
}

void folder_line(const Look& look, const BrowserView& view, FileForm& form, GuiCommands& commands) {
  const float up = kUpWidth * look.scale;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - up - ImGui::GetStyle().ItemSpacing.x);
  // Stays in the field, so that what was mistyped can be corrected.
  if (std::exchange(form.entered, false) && !view.problem.empty()) ImGui::SetKeyboardFocusHere();
  const bool begins = path_begins(view, form);
  bool entered = ImGui::InputText("##folder", form.folder.data(), form.folder.size(),
                                  ImGuiInputTextFlags_EnterReturnsTrue);
  if (begins) {
    go_to_end_of_field();
    entered = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false);
  }
  if (entered) {
    commands.push_back(ChooseFile{form.folder.data()});
    form.entered = true;
  }
  // The one that was typed last counts.
  if (ImGui::IsItemEdited() && !is_saving(view.purpose)) form.name[0] = 0;
  tip(tr("tip.folder_line"));
  ImGui::SameLine();
  up_button(look, view, commands);
}

/// One click chooses a file; a second click on it, or Enter, takes it. A folder opens at the first
/// click.
void entry_list(const Look& look, const BrowserView& view, FileForm& form, float height,
                GuiCommands& commands) {
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(8 * look.scale, 6 * look.scale));
  if (ImGui::BeginChild("entries", ImVec2(0, height), false,
                        ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NavFlattened)) {
    const bool saving = is_saving(view.purpose);
    for (const FileEntry& entry : view.entries) {
      const bool chosen = !entry.folder && entry.name == form.name.data();
      const std::string shown = entry.folder ? entry.name + "/" : entry.name;
      ImGui::PushStyleColor(ImGuiCol_Text, entry.folder ? ImGui::GetColorU32(ImGuiCol_PlotLines)
                                                        : ImGui::GetColorU32(ImGuiCol_Text));
      const bool clicked = list_item(shown, chosen, ImGuiSelectableFlags_AllowDoubleClick);
      if (std::exchange(form.to_first, false)) focus_here(false);
      // What was gone or typed to is chosen, so that the button below opens it; not on the way
      // there from a path that was typed.
      if (!saving && !path_is_typed(view, form) && !entry.folder && focus_is_here())
        set_text(form.name, entry.name);
      ImGui::PopStyleColor();
      if (!clicked) continue;
      if (entry.folder) {
        commands.push_back(EnterFolder{entry.name});
      } else {
        set_text(form.name, entry.name);
        set_text(form.folder, view.folder);
        const bool takes = ImGui::IsMouseDoubleClicked(0) || (used_by_keys() && !saving);
        if (takes) commands.push_back(ChooseFile{entry.name});
      }
    }
    if (view.entries.empty()) ImGui::TextDisabled("%s", tr("file.empty"));
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
}

/// The first `lines` lines of a text: a file can have many errors, and the list must stay in sight.
std::string first_lines(const std::string& text, int lines) {
  std::size_t end = 0;
  while (lines-- > 0 && end != std::string::npos) end = text.find('\n', end + 1);
  return end == std::string::npos ? text : text.substr(0, end) + "\n...";
}

/// What is chosen in the list or typed at present.
std::string choice_in(const FileForm& form) {
  return std::string(form.folder.data()) + '\n' + form.name.data();
}

/// Why the folder cannot be shown or the file not be taken, if that is still what is chosen; empty:
/// nothing is wrong.
std::string problem_of(const BrowserView& view, const FileForm& form) {
  const bool another = !form.tried.empty() && form.tried != choice_in(form);
  return another ? std::string() : view.problem;
}

/// Why the file was not taken; empty: nothing is wrong.
std::string objection(const BrowserView& view, const FileForm& form) {
  constexpr int kLinesMost = 3;
  const std::string problem = problem_of(view, form);
  if (!problem.empty()) return first_lines(problem, kLinesMost);
  if (is_saving(view.purpose) && form.name[0] == 0) return tr("file.unnamed");
  return view.replaces.empty() ? std::string() : tr("file.there", view.replaces);
}

/// The height that decide() needs, with room for an objection, so that the buttons stay in place.
float height_of_decision(const BrowserView& view, const FileForm& form) {
  const float gap = ImGui::GetStyle().ItemSpacing.y;
  float height = ImGui::GetFrameHeight() + gap;
  if (is_saving(view.purpose)) height += ImGui::GetFrameHeight() + gap;
  const std::string text = objection(view, form);
  if (text.empty()) return height;
  const float width = ImGui::GetContentRegionAvail().x;
  return height + ImGui::CalcTextSize(text.c_str(), nullptr, false, width).y + gap;
}

/// How the file that is chosen would be read: always one line, so that no file moves away from
/// under the pointer that has chosen it.
void table_line(const TableSettings& now, bool asked) {
  const bool usual = now == TableSettings{};
  const std::string words = table_in_words(now);
  const std::string text = usual   ? tr("file.tables_usual")
                           : asked ? tr("file.tables_applied", words)
                                   : tr("file.tables_kept", words);
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  fitted_text(text, right, colour_of(usual ? Tone::Quiet : Tone::Waiting));
  tip(text);
}

/// The settings for a recogniser's table. Initially folded.
void table_settings(const Look& look, const TablesView& tables, const std::string& file,
                    GuiCommands& commands) {
  const TableSettings now = settings_for(tables, file);
  const bool open = foldable(tr("file.tables"));
  tip(tr("tip.file_tables"));
  table_line(now, tables.asked.has_value());
  if (!open) return;
  TableSettings settings = now;
  bool changed = false;
  const auto number = [&](const char* name, const char* id, int& value, int most, int step,
                          const char* zero, const char* help, int first = 0) {
    changed |= number_row(
        look, name, id, value,
        {.near = step, .far = 10 * step, .most = most, .zero = zero, .first = first}, help);
  };
  number(tr("file.fps"), "##fps", settings.fps, kTableFpsMax, 1, tr("file.fps_zero"),
         tr("file.fps_tip"));
  number(tr("file.rate"), "##rate", settings.rate, 100, 1, tr("file.rate_zero"),
         tr("file.rate_tip"));
  // As it is is 100 %: the gain is stepped from there.
  number(tr("file.gain"), "##gain", settings.gain_percent, kTableGainPercentMax, 10,
         tr("file.gain_zero"), tr("file.gain_tip"), 100);
  number(tr("file.neutral"), "##neutral", settings.neutral_s, kTableNeutralMax, 1,
         tr("file.neutral_zero"), tr("file.neutral_tip"));
  if (wide_button(tr("file.tables_anew"), 0, 1, now != TableSettings{})) {
    settings = {};
    changed = true;
  }
  if (changed) commands.push_back(ChangeTable{settings});
}

/// ImGui takes some frames to bring the focus to the field: what is typed meanwhile waits for it.
void keep_typed(FileForm& form) {
  auto& typed = ImGui::GetIO().InputQueueCharacters;
  if (form.waits) {
    form.typed.insert(form.typed.end(), typed.begin(), typed.end());
  } else if (!form.typed.empty()) {
    form.typed.insert(form.typed.end(), typed.begin(), typed.end());
    typed.clear();
    for (const unsigned character : form.typed) typed.push_back(static_cast<ImWchar>(character));
    form.typed.clear();
  }
}

void decide(const Look& look, const BrowserView& view, FileForm& form, GuiCommands& commands) {
  const bool saving = is_saving(view.purpose);
  bool entered = false;
  if (saving) {
    label(look, tr("file.name"), tr("tip.new_name"));
    // What was refused can be typed on.
    form.to_name |= std::exchange(form.named, false) && !view.problem.empty();
    if (std::exchange(form.to_name, false)) {
      ImGui::SetKeyboardFocusHere();
      form.waits = true;
    }
    keep_typed(form);
    entered =
        ImGui::InputText("##name", form.name.data(), form.name.size(),
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    tip(tr("tip.new_name"));
    if (ImGui::IsItemActive() || ImGui::IsAnyMouseDown()) form.waits = false;
  }
  const std::string text = objection(view, form);
  if (!text.empty()) toned_text(problem_of(view, form).empty() ? Tone::Waiting : Tone::Bad, text);
  const bool folder = is_folder(view.purpose);
  const char* action = folder                  ? tr("file.this_folder")
                       : !saving               ? tr("button.open")
                       : view.replaces.empty() ? tr("button.save")
                                               : tr("file.replace");
  // A path that was typed above is opened by the button too, if none is chosen in the list.
  const bool typed = !saving && !folder && form.name[0] == 0 && path_is_typed(view, form);
  const bool named = folder || typed || form.name[0] != 0;
  if (wide_button(tr("button.cancel"), 0, 2, true)) commands.push_back(CloseBrowser{});
  tip(tr("tip.file_cancel"));
  const bool pressed = wide_button(action, 1, 2, named, named);
  tip(tr("tip.file_take"));
  // Behind a click on a file Enter opens it, as a second click does.
  entered |= !saving && !folder && entered_nowhere();
  if (named && (pressed || entered)) {
    form.named = saving;
    commands.push_back(ChooseFile{folder ? "." : typed ? form.folder.data() : form.name.data()});
  }
}

}  // namespace

void file_dialog(const Look& look, const GuiModel& model, FileForm& form, GuiCommands& commands) {
  const BrowserView& view = model.browser;
  constexpr const char* kId = "###files";
  if (!view.open) {
    form.shown_folder.clear();
    form.tried.clear();
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
    form.to_first = !is_saving(view.purpose);
    form.to_name = is_saving(view.purpose);
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
  const std::size_t before = commands.size();
  folder_line(look, view, form, commands);
  if (view.purpose == Purpose::PlayStream) {
    const auto file = std::filesystem::path(view.folder) / form.name.data();
    table_settings(look, model.tables, file.string(), commands);
  }
  const float below = height_of_decision(view, form);
  entry_list(look, view, form, std::max(ImGui::GetContentRegionAvail().y - below, 60.0F), commands);
  decide(look, view, form, commands);
  const bool escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (!shown || escaped) commands.push_back(CloseBrowser{});
  for (std::size_t i = before; i < commands.size(); ++i) {
    if (command_if<ChooseFile>(commands[i]) != nullptr) form.tried = choice_in(form);
    if (command_if<EnterFolder>(commands[i]) != nullptr) form.tried.clear();
  }
  ImGui::EndPopup();
}

}  // namespace aucast::gui
