#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

#include "client/gui/panels/panels.h"
#include "client/gui/texts/texts.h"
#include "client/gui/widgets/fields.h"
#include "client/gui/widgets/keyboard_focus.h"
#include "client/gui/widgets/tips.h"

namespace aucast::gui {
namespace {

constexpr float kTimelineHeight = 144;
constexpr float kTimelineMargin = 6;
constexpr float kPadHeight = 138;
constexpr float kSnap = 5;
/// One step by keys, as a share of the way from the middle to an edge.
constexpr float kPadStep = 0.05F;
constexpr int kAuColumns = 11;

void ask(GuiCommands& commands, ComposerCommand command) {
  commands.push_back(std::move(command));
}

void file_buttons(const ComposerView& composer, GuiCommands& commands) {
  if (wide_button(tr("button.new"), 0, 4, true)) ask(commands, NewComposition{});
  tip(tr("tip.new_stream"));
  if (wide_button(tr("button.open_dots"), 1, 4, true))
    commands.push_back(Browse{Purpose::ComposeStream});
  tip(tr("tip.open_stream"));
  const bool any = !composer.rows->empty();
  const std::string why_not = any ? "" : tr("compose.save_none");
  if (wide_button(tr("button.save"), 2, 4, any && composer.unsaved))
    ask(commands, SaveComposition{});
  tip(why_not, true);
  if (wide_button(tr("button.save_as"), 3, 4, any)) commands.push_back(Browse{Purpose::SaveStream});
  tip(why_not, true);
}

/// A keyframe as a line: its face, its AUs and the time to reach it.
void timeline_row(const Look& look, const ComposerView& composer, int index, Thumbnails& pictures,
                  GuiCommands& commands) {
  const TimelineRow& row = (*composer.rows)[static_cast<std::size_t>(index)];
  const float height = kKeyframeHeight * look.scale;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool chosen = index == composer.chosen;
  if (ImGui::Selectable("##row", chosen, 0, ImVec2(0, height))) {
    ask(commands, ChooseKeyframe{chosen ? -1 : index});
  }
  const bool visible = ImGui::IsItemVisible();
  const ImVec2 below = ImGui::GetCursorScreenPos();
  const float picture = at.x + kKeyframeWidth * look.scale;
  if (visible) draw_thumbnail(pictures, row.aus, at, ImVec2(picture, at.y + height));
  const float line = at.y + (height - ImGui::GetTextLineHeight()) / 2;
  const float left = picture + 8 * look.scale;
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x -
                      ImGui::CalcTextSize(row.time.c_str()).x;
  ImGui::SetCursorScreenPos(ImVec2(left, line));
  fitted_text(std::to_string(index + 1) + "   " + row.aus, right - 10 * look.scale);
  ImGui::SetCursorScreenPos(ImVec2(right, line));
  // Grey could not be read on the colour of a chosen row.
  if (chosen) {
    ImGui::TextUnformatted(row.time.c_str());
  } else {
    toned_line(Tone::Quiet, row.time);
  }
  ImGui::SetCursorScreenPos(below);
}

/// The height from one row of the timeline to the next.
float row_height(const Look& look) {
  return kKeyframeHeight * look.scale + ImGui::GetStyle().ItemSpacing.y;
}

/// Scrolls to the chosen keyframe if it was added, or chosen in another way than by a click, such
/// as Undo.
void scroll_to_news(const Look& look, const ComposerView& composer, ComposerForm& form) {
  const int rows = static_cast<int>(composer.rows->size());
  const bool added = rows == std::exchange(form.rows, rows) + 1;  // and not loaded
  const bool other = std::exchange(form.chosen, composer.chosen) != composer.chosen;
  if (!added && !(other && composer.chosen >= 0)) return;
  const int row = composer.chosen >= 0 ? composer.chosen : rows - 1;
  const float top = static_cast<float>(row) * row_height(look);
  const float room = ImGui::GetWindowHeight() - 2 * kTimelineMargin * look.scale;
  const float lowest = top + row_height(look) - room;
  ImGui::SetScrollY(std::clamp(ImGui::GetScrollY(), std::min(lowest, top), top));
}

void timeline(const Look& look, const ComposerView& composer, ComposerForm& form,
              GuiCommands& commands) {
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                      ImVec2(8 * look.scale, kTimelineMargin * look.scale));
  const bool visible =
      ImGui::BeginChild("timeline", ImVec2(0, kTimelineHeight * look.scale), false,
                        ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NavFlattened);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  if (visible) {
    scroll_to_news(look, composer, form);
    if (composer.rows->empty()) quiet_text(tr("compose.empty"));
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(composer.rows->size()), row_height(look));
    while (clipper.Step()) {
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
        ImGui::PushID(i);
        timeline_row(look, composer, i, form.pictures, commands);
        ImGui::PopID();
      }
    }
  }
  ImGui::EndChild();
}

void timeline_part(const Look& look, const ComposerView& composer, ComposerForm& form,
                   GuiCommands& commands) {
  std::string name = std::filesystem::path(composer.file).filename().string();
  if (name.empty()) name = tr("compose.new_stream");
  heading(look, composer.unsaved ? tr("compose.unsaved", name) : name);
  tip(composer.file);
  file_buttons(composer, commands);
  timeline(look, composer, form, commands);
  const bool chosen = composer.chosen >= 0;
  const int last = static_cast<int>(composer.rows->size()) - 1;
  if (wide_button(tr("compose.play"), 0, 4, last >= 0)) ask(commands, PlayComposition{});
  if (wide_button(tr("compose.up"), 1, 4, composer.chosen > 0)) ask(commands, MoveKeyframe{-1});
  if (wide_button(tr("compose.down"), 2, 4, chosen && composer.chosen < last))
    ask(commands, MoveKeyframe{1});
  if (wide_button(tr("button.delete"), 3, 4, chosen)) ask(commands, RemoveKeyframe{});
  quiet_text(composer.total);
}

void time_of_keyframe(const Look& look, const ComposerView& composer, GuiCommands& commands) {
  bool own = composer.ms.has_value();
  label(look, tr("compose.time"), tr("tip.time"));
  if (ImGui::Checkbox("##own", &own)) {
    ask(commands, ComposeTime{own ? std::optional(500) : std::nullopt, false});
  }
  tip(tr("compose.time_tip"));
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  int ms = composer.ms.value_or(0);
  ImGui::BeginDisabled(!composer.ms);
  if (number_field("##ms", ms, {.near = 50, .far = 500})) ask(commands, ComposeTime{ms, false});
  ImGui::EndDisabled();
}

/// The place, moved onto a prototype that is within these distances.
std::array<float, 2> snapped(const ComposerView& composer, float x, float y, float near_x,
                             float near_y) {
  for (const PadPoint& point : *composer.pad) {
    if (std::abs(x - point.x) < near_x && std::abs(y - point.y) < near_y) {
      return {point.x, point.y};
    }
  }
  return {x, y};
}

/// Carries out the arrows of the pad.
void step_on_pad(const ComposerView& composer, const ArrowSteps& arrows, GuiCommands& commands) {
  if (arrows.right == 0 && arrows.up == 0) return;
  const std::array<float, 2> at = composer.pad_at.value_or(std::array<float, 2>{});
  const auto stepped = [](float from, int steps) {
    return std::clamp(from + kPadStep * static_cast<float>(steps), -1.0F, 1.0F);
  };
  constexpr float kNear = kPadStep / 2;
  const auto [x, y] =
      snapped(composer, stepped(at[0], arrows.right), stepped(at[1], arrows.up), kNear, kNear);
  ask(commands, ComposeMood{x, y, arrows.continued});
}

/// Draws the prototypes. Returns the one whose word the pointer is on; null: none.
const PadPoint* prototypes(const Look& look, const ComposerView& composer, ImVec2 middle,
                           ImVec2 reach) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float row = ImGui::GetTextLineHeight();
  const PadPoint* pointed = nullptr;
  for (const PadPoint& point : *composer.pad) {
    const ImVec2 at(middle.x + point.x * reach.x, middle.y - point.y * reach.y);
    list.AddCircleFilled(at, 3 * look.scale, ImGui::GetColorU32(ImGuiCol_PlotLines), 16);
    const std::string label = data_word(point.label);
    const float width = ImGui::CalcTextSize(label.c_str()).x;
    // Beside the dot, towards the middle, where there is room.
    const float x = point.x > 0.3F ? at.x - width - 6 * look.scale : at.x + 6 * look.scale;
    const ImVec2 from(x, at.y - row / 2);
    list.AddText(from, ImGui::GetColorU32(ImGuiCol_Text), label.c_str());
    if (ImGui::IsMouseHoveringRect(from, ImVec2(x + width, from.y + row))) pointed = &point;
  }
  return pointed;
}

/// The two emotional axes of thesis figure 3.3, with the prototypes where they lie.
void pad(const Look& look, const ComposerView& composer, GuiCommands& commands) {
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, kPadHeight * look.scale);
  const bool pressed = ImGui::InvisibleButton("##pad", size);
  const bool active = held_by_mouse();
  const bool continued = belongs_to_drag();
  const ArrowSteps arrows = arrows_of_item(pressed);
  mark_focus();
  if (focus_is_here()) tip(arrows.held ? tr("tip.pad_held") : tr("tip.pad"));
  step_on_pad(composer, arrows, commands);
  const ImVec2 to(from.x + size.x, from.y + size.y);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float margin = 14 * look.scale;
  const ImVec2 middle((from.x + to.x) / 2, (from.y + to.y) / 2);
  const ImVec2 reach(size.x / 2 - margin, size.y / 2 - margin);
  list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg),
                     ImGui::GetStyle().FrameRounding);
  const unsigned line = ImGui::GetColorU32(ImGuiCol_Border);
  list.AddLine(ImVec2(from.x + margin, middle.y), ImVec2(to.x - margin, middle.y), line);
  const unsigned quiet = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  const float row = ImGui::GetTextLineHeight();
  list.AddLine(ImVec2(middle.x, from.y + row + margin / 2), ImVec2(middle.x, to.y - margin), line);
  const auto word = [&](const char* text, float x, float y) {
    list.AddText(ImVec2(x, y), quiet, text);
  };
  const float gap = 4 * look.scale;
  word(tr("compose.sad"), from.x + gap, middle.y);
  word(tr("compose.happy"), to.x - ImGui::CalcTextSize(tr("compose.happy")).x - gap, middle.y);
  // Over the axis, for beside it are prototypes.
  word(tr("compose.excited"), middle.x - ImGui::CalcTextSize(tr("compose.excited")).x / 2,
       from.y + gap / 2);
  word(tr("compose.calm"), middle.x - ImGui::CalcTextSize(tr("compose.calm")).x - gap,
       to.y - row - gap / 2);
  const PadPoint* const word_of = prototypes(look, composer, middle, reach);
  if (composer.pad_at) {
    const ImVec2 at(middle.x + (*composer.pad_at)[0] * reach.x,
                    middle.y - (*composer.pad_at)[1] * reach.y);
    list.AddCircle(at, 7 * look.scale, colour_of(Tone::Waiting), 24, 2 * look.scale);
  }
  if (!active) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const float near = kSnap * look.scale;
  // Who clicks on a word means it, not the place where it is written.
  const bool named = word_of != nullptr && !ImGui::IsMouseDragging(0);
  const std::array<float, 2> wanted =
      named ? std::array<float, 2>{word_of->x, word_of->y}
            : snapped(composer, std::clamp((mouse.x - middle.x) / reach.x, -1.0F, 1.0F),
                      std::clamp((middle.y - mouse.y) / reach.y, -1.0F, 1.0F), near / reach.x,
                      near / reach.y);
  if (composer.pad_at == wanted) return;
  ask(commands, ComposeMood{wanted[0], wanted[1], continued});
}

/// All AUs that the face has, as small buttons: on is 100 %.
void au_grid(const GuiModel& model, GuiCommands& commands) {
  const ComposerView& composer = model.composer;
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width =
      (ImGui::GetContentRegionAvail().x - gap * (kAuColumns - 1)) / static_cast<float>(kAuColumns);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 2));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, gap));
  int place = 0;
  for (const AuEntry& entry : *model.known_aus) {
    const bool on = std::any_of(composer.aus.begin(), composer.aus.end(),
                                [&](const auto& one) { return one.number == entry.number; });
    if (place++ % kAuColumns != 0) ImGui::SameLine(0, gap);
    ImGui::PushID(entry.number);
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_Header));
    if (ImGui::Button(std::to_string(entry.number).c_str(), ImVec2(width, 0))) {
      const int percent = on ? 0 : 100;
      ask(commands, ComposeAu{entry.number, percent, percent, false});
    }
    if (on) ImGui::PopStyleColor();
    tip(std::to_string(entry.number) + "  " + au_name(entry.number, entry.name));
    ImGui::PopID();
  }
  ImGui::PopStyleVar(2);
}

/// Both sides in one slider, beside the name.
void joined_slider(const Look& look, const ComposedAu& au, const std::string& name,
                   GuiCommands& commands) {
  ImGui::AlignTextToFramePadding();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float column = 176 * look.scale;
  fitted_text(name, at.x + column - 8 * look.scale);
  tip(name);
  ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + column);
  int both = au.left_percent;
  if (!percent_slider("##both", ImGui::GetContentRegionAvail().x, both)) return;
  ask(commands, ComposeAu{au.number, both, both, belongs_to_drag()});
}

/// Both sides below the name, each with half of the line.
void split_sliders(const ComposedAu& au, const std::string& name, GuiCommands& commands) {
  ImGui::TextUnformatted(name.c_str());
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float half = (ImGui::GetContentRegionAvail().x - gap) / 2;
  int left = au.left_percent;
  int right = au.right_percent;
  bool changed = percent_slider("##right", half, right);
  bool continued = belongs_to_drag();
  ImGui::SameLine(0, gap);
  changed |= percent_slider("##left", half, left);
  continued |= belongs_to_drag();
  if (changed) ask(commands, ComposeAu{au.number, left, right, continued});
}

void au_sliders(const Look& look, const ComposerView& composer, bool linked,
                GuiCommands& commands) {
  bool headed = false;
  for (const ComposedAu& au : composer.aus) {
    ImGui::PushID(au.number);
    const std::string name = std::to_string(au.number) + "  " + au_name(au.number, au.name);
    if (linked && au.left_percent == au.right_percent) {
      joined_slider(look, au, name, commands);
    } else {
      if (!std::exchange(headed, true)) sides_heading();
      split_sliders(au, name, commands);
    }
    ImGui::PopID();
  }
}

/// Which keyframe is being composed. If the face shows something else, it says so by a button that
/// ends that.
void keyframe_heading(const Look& look, const ComposerView& composer, GuiCommands& commands) {
  const std::string text = composer.chosen >= 0 ? tr("compose.keyframe", composer.chosen + 1)
                                                : tr("compose.new_keyframe");
  if (!composer.aside) return heading(look, text, tr("tip.keyframe"));
  // Only the button does: what the face shows may be there to be taken.
  const bool asked = heading_with_button(look, text, tr("tip.keyframe"), tr("button.show"),
                                         "composed", tr("compose.show_tip"));
  if (asked) ask(commands, ShowComposed{});
}

}  // namespace

void composer_panel(const Look& look, const GuiModel& model, ComposerForm& form,
                    GuiCommands& commands) {
  const ComposerView& composer = model.composer;
  if (composer.rows == nullptr || composer.pad == nullptr || model.known_aus == nullptr) return;
  timeline_part(look, composer, form, commands);
  const bool chosen = composer.chosen >= 0;
  keyframe_heading(look, composer, commands);
  const char* add = chosen ? tr("compose.double") : tr("compose.add");
  if (wide_button(add, 0, 5, true, !chosen)) ask(commands, AddKeyframe{});
  tip(tr("tip.add_keyframe"));
  if (wide_button(tr("button.neutral"), 1, 5, true)) ask(commands, ComposeNeutral{});
  tip(tr("tip.neutral"));
  if (wide_button(tr("compose.take"), 2, 5, composer.can_take)) ask(commands, ComposeShown{});
  tip(composer.can_take ? tr("compose.take_tip") : tr("compose.take_none"), true);
  if (wide_button(tr("button.undo"), 3, 5, composer.can_undo)) ask(commands, UndoComposing{});
  tip(tr("tip.undo"));
  if (wide_button(tr("button.redo"), 4, 5, composer.can_redo)) ask(commands, RedoComposing{});
  tip(tr("tip.redo"));
  time_of_keyframe(look, composer, commands);
  pad(look, composer, commands);
  au_grid(model, commands);
  if (composer.aus.empty()) return;
  ImGui::Checkbox(tr("panel.linked"), &form.linked);
  tip(tr("tip.linked"));
  au_sliders(look, composer, form.linked, commands);
}

}  // namespace aucast::gui
