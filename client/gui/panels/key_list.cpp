#include "client/gui/panels/key_list.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <span>

#include "client/gui/texts/texts.h"

namespace aucast::gui {
namespace {

struct KeyHelp {
  TextKey key;
  TextKey meaning;
};
constexpr std::array<KeyHelp, 28> kKeys = {{
    {"keys.space", "keys.does_pause"},       {"keys.left_right", "keys.does_seek"},
    {"keys.home_end", "keys.does_ends"},     {"keys.pages", "keys.does_keyframe"},
    {"keys.frame", "keys.does_frame"},       {"keys.speed", "keys.does_speed"},
    {"keys.loop", "keys.does_loop"},         {"keys.repeat", "keys.does_repeat"},
    {"keys.mute", "keys.does_mute"},         {"keys.volume", "keys.does_volume"},
    {"keys.captions", "keys.does_captions"}, {"keys.open", "keys.does_open"},
    {"keys.tab", "keys.does_focus"},         {"keys.use", "keys.does_use"},
    {"keys.panel", "keys.does_panel"},       {"keys.bare", "keys.does_bare"},
    {"keys.full", "keys.does_full"},         {"keys.picture", "keys.does_picture"},
    {"keys.video", "keys.does_video"},       {"keys.undo", "keys.does_undo"},
    {"keys.save", "keys.does_save"},         {"keys.reset", "keys.does_reset"},
    {"keys.list", "keys.does_list"},         {"keys.escape", "keys.does_close"},
    {"keys.leave", "keys.does_leave"},       {"keys.left_drag", "keys.does_turn"},
    {"keys.right_drag", "keys.does_move"},   {"keys.wheel", "keys.does_zoom"},
}};

/// A column of the list.
struct KeyColumn {
  std::span<const KeyHelp> lines;
  float key = 0;  ///< widths
  float meaning = 0;
  [[nodiscard]] float width() const { return key + meaning; }
};

KeyColumn column_of(std::span<const KeyHelp> lines) {
  KeyColumn column{lines};
  const float gap = ImGui::GetStyle().WindowPadding.x;
  for (const KeyHelp& line : lines) {
    column.key = std::max(column.key, ImGui::CalcTextSize(tr(line.key)).x + gap);
    column.meaning = std::max(column.meaning, ImGui::CalcTextSize(tr(line.meaning)).x);
  }
  return column;
}

void key_help(const KeyColumn& column, std::size_t row, float left) {
  if (row >= column.lines.size()) return;
  const float margin = ImGui::GetStyle().WindowPadding.x;
  if (left > 0) ImGui::SameLine(margin + left);
  ImGui::TextUnformatted(tr(column.lines[row].key));
  ImGui::SameLine(margin + left + column.key);
  toned_line(Tone::Quiet, tr(column.lines[row].meaning));
}

}  // namespace

/// In the middle of what the panel leaves free, in two columns if one would be too high for the
/// window. If it is still too large, it scrolls.
void key_list(const Look& look, float width, bool& shown) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float margin = 10 * look.scale;
  const ImVec2 most(screen.x - 2 * margin, screen.y - 2 * margin);
  const std::span<const KeyHelp> all = kKeys;
  const std::size_t half = (all.size() + 1) / 2;
  const float gap = 1.5F * ImGui::GetStyle().WindowPadding.x;
  const float padding = 2 * ImGui::GetStyle().WindowPadding.x;
  std::array<KeyColumn, 2> columns = {column_of(all.first(half)), column_of(all.subspan(half))};
  const float lines = ImGui::GetTextLineHeightWithSpacing() * static_cast<float>(all.size());
  const bool high = lines + 3 * ImGui::GetFrameHeight() > most.y;
  if (!high || columns[0].width() + columns[1].width() + gap + padding > most.x) {
    columns = {column_of(all), {}};
  }
  const float content =
      columns[0].width() + (columns[1].lines.empty() ? 0 : gap + columns[1].width());
  const bool beside = content + padding <= width;
  ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), most);
  // By itself it is as wide as what was drawn a frame before, in another language perhaps.
  ImGui::SetNextWindowContentSize(ImVec2(content, 0));
  ImGui::SetNextWindowPos(ImVec2((beside ? width : screen.x) / 2, ImGui::GetIO().DisplaySize.y / 2),
                          ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                      ImGuiWindowFlags_AlwaysAutoResize |
                                      ImGuiWindowFlags_NoSavedSettings;
  const FloatingStyle floating(look);
  if (ImGui::Begin(with_id(tr("keys.title"), "keys").c_str(), &shown, kFlags)) {
    for (std::size_t row = 0; row < columns[0].lines.size(); ++row) {
      key_help(columns[0], row, 0);
      key_help(columns[1], row, columns[0].width() + gap);
    }
  }
  ImGui::End();
}

}  // namespace aucast::gui
