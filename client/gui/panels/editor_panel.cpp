#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "client/gui/panels/panels.h"
#include "client/gui/texts/texts.h"
#include "client/gui/widgets/fields.h"
#include "client/gui/widgets/kept_place.h"
#include "client/gui/widgets/keyboard_focus.h"
#include "client/gui/widgets/tips.h"
#include "common/action_unit.h"
#include "common/text.h"
#include "common/text_file.h"

namespace aucast::gui {
namespace {

constexpr float kStep = 0.05F;
/// Enough for most AUs; longer texts scroll.
constexpr float kSaidLines = 6;

std::string title_of(const AuEntry& entry) {
  const std::string title = std::to_string(entry.number) + "  " + au_name(entry.number, entry.name);
  return entry.own ? tr("editor.yours", title) : title;
}

const AuEntry* entry_of(const GuiModel& model, int number) {
  const auto& all = *model.known_aus;
  const auto found = std::find_if(all.begin(), all.end(),
                                  [number](const AuEntry& one) { return one.number == number; });
  return found == all.end() ? nullptr : &*found;
}

/// The name as it was typed, else as it is saved.
std::string name_of(const GuiModel& model, int number, bool unnamed) {
  if (!unnamed) return au_name(number);
  const auto typed = model.editor.names.find(number);
  if (typed != model.editor.names.end()) return typed->second;
  const AuEntry* entry = entry_of(model, number);
  return entry == nullptr ? "" : entry->name;
}

/// The field for the name of an AU that FACS does not name. Returns whether Enter was pressed in
/// it.
bool name_field(const Look& look, const GuiModel& model, int number, bool unnamed, EditorForm& form,
                GuiCommands& commands) {
  const std::string name = name_of(model, number, unnamed);
  const bool another = std::exchange(form.named, number) != number;
  const bool renamed = std::exchange(form.name_taken, name) != name;
  if ((another || renamed) && name != form.name.data()) {
    set_text(form.name, name);
  }
  const std::string before = form.name.data();
  label(look, tr("editor.name"), tr("tip.au_name"));
  if (!unnamed) {
    // No field, which one would try to type into.
    fitted_text(name, ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x,
                colour_of(Tone::Quiet));
    if (number > 0) tip(tr("editor.name_of_facs"));
    return false;
  }
  if (std::exchange(form.to_name, false)) ImGui::SetKeyboardFocusHere();
  const bool entered =
      ImGui::InputTextWithHint("##auname", tr("editor.name_hint"), form.name.data(),
                               form.name.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  stay_in_field();
  tip(tr("tip.au_name"));
  if (before != form.name.data()) commands.push_back(NameAu{number, form.name.data()});
  return entered;
}

/// What is known about an AU, in an area of constant height, so that nothing below moves.
void said_of_au(const AuEntry* entry) {
  const float height = kSaidLines * ImGui::GetTextLineHeight() + ImGui::GetStyle().ItemSpacing.y;
  if (ImGui::BeginChild("said", ImVec2(0, height), false, ImGuiWindowFlags_NavFlattened)) {
    if (entry == nullptr) {
      quiet_text(tr("editor.how"));
    } else {
      if (!entry->looks.empty()) {
        ImGui::TextWrapped("%s", au_looks(entry->number, entry->looks).c_str());
      }
      quiet_text(entry->muscles);
    }
  }
  ImGui::EndChild();
}

/// The tip of the button: what it does, or why it cannot.
const char* help_of_removing(const AuEntry* entry) {
  if (entry == nullptr) return tr("editor.not_there_tip");
  if (entry->own) return entry->shipped ? tr("editor.as_it_came_tip") : tr("editor.delete_tip");
  return entry->shipped ? tr("editor.is_as_it_came_tip") : tr("editor.not_own_tip");
}

/// The buttons for saved AUs.
void au_file_buttons(const GuiModel& model, GuiCommands& commands) {
  const AuEntry* entry = entry_of(model, model.editor.au);
  const bool known = entry != nullptr;
  if (wide_button(tr("button.import"), 0, 3, true)) commands.push_back(Browse{Purpose::ImportAus});
  tip(tr("editor.import_tip"));
  if (wide_button(tr("button.export"), 1, 3, known)) commands.push_back(Browse{Purpose::ExportAu});
  tip(tr("tip.export_au"));
  const char* remove = known && !entry->shipped ? tr("button.delete") : tr("editor.as_it_came");
  if (wide_button(remove, 2, 3, known && entry->own)) commands.push_back(RemoveAu{entry->number});
  tip(help_of_removing(entry), true);
}

/// What a face with it looks like, and what it drives.
std::string about(const AuEntry& entry) {
  const std::string looks = entry.looks.empty() ? "" : au_looks(entry.number, entry.looks);
  return looks + (looks.empty() || entry.muscles.empty() ? "" : "\n") + entry.muscles;
}

/// The list of all AUs; returns whether one was chosen.
bool au_combo(const char* id, const GuiModel& model, const char* none, int& number) {
  std::string shown = none;
  for (const AuEntry& entry : *model.known_aus) {
    if (entry.number == number) shown = title_of(entry);
  }
  if (number >= 0 && shown == none) shown = tr("editor.new", number);
  const bool open = ImGui::BeginCombo(id, shown.c_str(), ImGuiComboFlags_HeightLarge);
  if (!open) {
    tip(number >= 0 ? shown : tr("tip.edit"));  // it may be cut
    return false;
  }
  bool chosen = false;
  for (const AuEntry& entry : *model.known_aus) {
    if (list_item(title_of(entry), entry.number == number)) {
      number = entry.number;
      chosen = true;
    }
    tip(about(entry));
  }
  ImGui::EndCombo();
  return chosen;
}

void au_buttons(const Look& look, const GuiModel& model, EditorForm& form, GuiCommands& commands) {
  const EditorView& editor = model.editor;
  heading(look, editor.unsaved ? tr("editor.title_unsaved") : tr("editor.title"), tr("tip.au"));
  label(look, tr("editor.edit"), tr("tip.edit"));
  int number = editor.au;
  if (au_combo("##edit", model, tr("editor.choose_one"), number)) {
    form.save_as = -1;
    commands.push_back(LoadAu{number});
  }
  if (wide_button(tr("button.undo"), 0, 4, editor.can_undo)) commands.push_back(Undo{});
  tip(tr("tip.undo"));
  if (wide_button(tr("button.redo"), 1, 4, editor.can_redo)) commands.push_back(Redo{});
  tip(tr("tip.redo"));
  if (wide_button(tr("button.revert"), 2, 4, editor.unsaved)) commands.push_back(RevertAu{});
  tip(tr("tip.revert"));
  if (wide_button(tr("button.neutral"), 3, 4, true)) commands.push_back(NeutralFace{});
  tip(tr("tip.neutral"));
  label(look, tr("editor.save_as"), tr("tip.save_as"));
  int target = std::max(0, form.save_as >= 0 ? form.save_as : editor.au);
  const float width = ImGui::GetContentRegionAvail().x;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float word =
      ImGui::CalcTextSize(tr("button.save")).x + 2 * ImGui::GetStyle().FramePadding.x;
  const float button = std::max((width - gap) / 2, word);
  // With large letters the button stands below, or the number had no room for its own.
  const bool beside = width - gap - button >= number_field_width();
  ImGui::SetNextItemWidth(beside ? width - gap - button : width);
  if (number_field("##as", target, {.least = 1, .most = kAuNumberMax})) form.save_as = target;
  tip(tr("tip.save_as"));
  target = form.save_as >= 0 ? form.save_as : editor.au;
  const bool unnamed = target > 0 && !facs_name(target);
  if (beside) ImGui::SameLine();
  ImGui::BeginDisabled(target < 1);
  const bool pressed = ImGui::Button(tr("button.save"), ImVec2(beside ? button : -1, 0));
  tip(tr("tip.save_au"));
  ImGui::EndDisabled();
  const bool entered = name_field(look, model, target, unnamed, form, commands);
  if (pressed || entered) {
    const std::string_view name = trimmed(form.name.data(), " ");
    form.to_name = unnamed && name.empty();
    commands.push_back(SaveAu{target, unnamed ? std::string(name) : std::string()});
  }
  au_file_buttons(model, commands);
  said_of_au(entry_of(model, editor.au));
  quiet_text(tr("editor.where"));
}

/// In hundredths, as it is shown: a file should not say 1.1499999.
float stepped(float value, float step) {
  return std::round((value + step) * 100) / 100;
}

/// A value with its steps: dragged, typed (Ctrl+click) or stepped.
void channel_slider(const Look& look, const char* id, int channel, float value, float maximum,
                    float width, GuiCommands& commands) {
  ImGui::PushID(id);
  const ImVec2 step_size(18 * look.scale, 0);
  const float gap = 2 * look.scale;
  float wanted = value;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, ImGui::GetStyle().FramePadding.y));
  const ImGuiID owner = ImGui::GetID("##value");
  if (step_button("-", step_size, owner))
    commands.push_back(SetChannel{channel, stepped(value, -kStep), false});
  ImGui::SameLine(0, gap);
  const float room = width - 2 * (step_size.x + gap);
  if (slider("##value", room, wanted, 0.0F, maximum, "%.2f")) {
    commands.push_back(SetChannel{channel, wanted, belongs_to_drag()});
  }
  if (!ImGui::IsItemActive()) tip(tr("panel.type_tip", number_text(static_cast<double>(maximum))));
  ImGui::SameLine(0, gap);
  if (step_button("+", step_size, owner))
    commands.push_back(SetChannel{channel, stepped(value, kStep), false});
  ImGui::PopStyleVar();
  ImGui::PopID();
}

/// Each side has a slider of its own.
bool is_split(const ChannelRow& row, bool linked) {
  return row.right >= 0 && !(linked && row.left_value == row.right_value);
}

/// Both sides below their name, each with half of the line.
void split_row(const Look& look, const ChannelRow& row, GuiCommands& commands) {
  ImGui::PushID(row.left);
  ImGui::TextUnformatted(row.name.c_str());
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float half = (ImGui::GetContentRegionAvail().x - gap) / 2;
  channel_slider(look, "right", row.right, row.right_value, row.maximum, half, commands);
  ImGui::SameLine(0, gap);
  channel_slider(look, "left", row.left, row.left_value, row.maximum, half, commands);
  ImGui::PopID();
}

void channel_row(const Look& look, const ChannelRow& row, GuiCommands& commands) {
  ImGui::PushID(row.left);
  mark_row(row.name);
  ImGui::AlignTextToFramePadding();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  fitted_text(row.name, at.x + 146 * look.scale);
  tip(row.name);
  ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + 150 * look.scale);
  const float width = ImGui::GetContentRegionAvail().x;
  channel_slider(look, row.right < 0 ? "centre" : "both", row.left, row.left_value, row.maximum,
                 width, commands);
  ImGui::PopID();
}

/// Whether any channel of the group is active.
bool in_use(const ChannelGroup& group) {
  return std::any_of(group.rows.begin(), group.rows.end(), [](const ChannelRow& row) {
    return row.left_value > 0 || row.right_value > 0;
  });
}

/// Says that the face shows something else than the sliders, and ends that. The button is at the
/// end of a line that is always there, so that nothing moves.
void show_edited(const GuiModel& model, bool comes, GuiCommands& commands) {
  if (!model.editor.aside) return;
  // Who comes back to it sees what is edited, unless something moves meanwhile.
  const bool moves =
      model.playing.activity == Activity::Playing || model.playing.activity == Activity::Connecting;
  if (comes && !moves) commands.push_back(ShowEdited{});
  const std::string text = with_id(tr("button.show"), "edited");
  const float width =
      ImGui::CalcTextSize(tr("button.show")).x + 2 * ImGui::GetStyle().FramePadding.x;
  if (has_room_beside(width)) ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
  if (ImGui::Button(text.c_str())) commands.push_back(ShowEdited{});
  tip(tr("editor.show_tip"));
}

void muscles(const Look& look, const GuiModel& model, EditorForm& form, GuiCommands& commands) {
  heading(look, tr("editor.muscles"), tr("tip.muscles"));
  bool linked = model.editor.linked;
  if (ImGui::Checkbox(tr("panel.linked"), &linked)) commands.push_back(SetLinked{linked});
  tip(tr("tip.linked"));
  show_edited(model, form.comes, commands);
  // What another AU drives is opened, so that it is there to be changed.
  const bool another = std::exchange(form.opened_for, model.editor.au) != model.editor.au;
  for (const ChannelGroup& group : model.editor.groups) {
    if (another) ImGui::SetNextItemOpen(in_use(group));
    const std::string name(group.name);
    mark_row(name);
    ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyleColorVec4(ImGuiCol_Button));
    const bool open = ImGui::CollapsingHeader(name.c_str());
    ImGui::PopStyleColor();
    if (!open) continue;
    bool headed = false;
    for (const ChannelRow& row : group.rows) {
      if (!is_split(row, linked)) {
        channel_row(look, row, commands);
        continue;
      }
      if (!std::exchange(headed, true)) sides_heading();
      split_row(look, row, commands);
    }
  }
}

}  // namespace

void editor_panel(const Look& look, const GuiModel& model, EditorForm& form,
                  GuiCommands& commands) {
  if (model.known_aus == nullptr) return;
  au_buttons(look, model, form, commands);
  muscles(look, model, form, commands);
}

}  // namespace aucast::gui
