#include "client/gui/widgets/au_table.h"

#include <imgui.h>

#include <array>
#include <string>

#include "client/gui/texts/texts.h"
#include "client/gui/widgets/kept_place.h"
#include "client/gui/widgets/tips.h"

namespace aucast::gui {
namespace {

void percent(int value, bool differs) {
  if (value == 0) {
    ImGui::TextDisabled("-");
  } else if (differs) {
    toned_line(Tone::Waiting, std::to_string(value));
  } else {
    ImGui::Text("%d", value);
  }
}

}  // namespace

void au_table(const Look& look, const AuTableWords& words, const std::vector<AuRow>& rows) {
  quiet_text(words.legend);
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg;
  if (!ImGui::BeginTable("aus", 4, kFlags)) return;
  ImGui::TableSetupColumn(tr("panel.au"), 0, 34 * look.scale);
  ImGui::TableSetupColumn(tr("panel.au_name"), ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn(words.given, 0, 58 * look.scale);
  ImGui::TableSetupColumn(tr("panel.shown"), 0, 46 * look.scale);
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  const std::array<const char*, 4> tips = {tr("tip.au"), "", words.given_tip, words.shown_tip};
  for (int column = 0; column < 4; ++column) {
    ImGui::TableSetColumnIndex(column);
    ImGui::TableHeader(ImGui::TableGetColumnName(column));
    tip(tips[static_cast<std::size_t>(column)]);
  }
  for (const AuRow& row : rows) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    mark_row(row.label);
    const bool idle = row.received_percent + row.shown_percent == 0;
    if (idle) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextUnformatted(row.label.c_str());
    ImGui::TableNextColumn();
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    const bool cut = ImGui::CalcTextSize(row.name.c_str()).x > ImGui::GetContentRegionAvail().x;
    fitted_text(row.name, right);
    if (idle) ImGui::PopStyleColor();
    if (cut) tip(row.name);
    if (!row.why.empty()) {
      quiet_text(row.why);
      tip(tr("tip.rule"));
    } else if (row.room_for_why) {
      ImGui::NewLine();
    }
    ImGui::TableNextColumn();
    percent(row.received_percent, false);
    ImGui::TableNextColumn();
    percent(row.shown_percent, !row.why.empty());
    if (row.received_percent != row.shown_percent) tip(words.shown_tip);
  }
  ImGui::EndTable();
}

}  // namespace aucast::gui
