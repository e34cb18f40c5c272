#include <imgui.h>

#include <algorithm>
#include <filesystem>

#include "client/gui/panels/panels.h"
#include "client/gui/texts/texts.h"
#include "client/gui/widgets/tips.h"

namespace aucast::gui {
namespace {

constexpr std::size_t kFilesShown = 4;
constexpr float kWidth = 300;
/// With less the buttons need all of it.
constexpr float kWidthForWords = 140;

void contents(const GuiModel& model, const char* words, GuiCommands& commands) {
  if (wide_button(tr("play.sample"), 0, 2, !model.sample.empty(), !model.sample.empty())) {
    commands.push_back(OpenStream{model.sample});
  }
  tip(tr("tip.sample"));
  if (wide_button(tr("button.open_file"), 1, 2, true))
    commands.push_back(Browse{Purpose::PlayStream});
  tip(tr("tip.open_file"));
  for (std::size_t i = 0; i < std::min(model.recent_files.size(), kFilesShown); ++i) {
    const std::filesystem::path file = model.recent_files[i];
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::Selectable("##file")) commands.push_back(OpenStream{file.string()});
    tip(file.string());
    ImGui::SameLine();
    fitted_text(file.filename().string(),
                ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x);
    ImGui::PopID();
  }
  if (*words != 0) quiet_text(words);
}

}  // namespace

void welcome(const Look& look, const GuiModel& model, float width, GuiCommands& commands) {
  const bool made = model.editor.active || model.composer.active;
  if (model.playing.activity != Activity::Idle || model.local.open || made) return;
  if (!model.notice.text.empty()) return;  // it stands at the same place
  const float own = std::min(kWidth * look.scale, width - 20 * look.scale);
  const float bottom = ImGui::GetIO().DisplaySize.y - 14 * look.scale;
  ImGui::SetNextWindowPos(ImVec2(width / 2, bottom), ImGuiCond_Always, ImVec2(0.5F, 1));
  ImGui::SetNextWindowSize(ImVec2(own, 0));
  constexpr ImGuiWindowFlags kFlags =
      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
      ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBringToFrontOnFocus;
  const FloatingStyle floating(look);
  const bool narrow = own < kWidthForWords * look.scale;
  const bool panel = width < ImGui::GetIO().DisplaySize.x;
  const char* const words = narrow  ? ""
                            : panel ? tr("play.or_connect")
                                    : tr("play.or_connect_hidden");
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                      narrow ? ImVec2(padding.x / 4, padding.y / 4) : padding);
  if (ImGui::Begin("welcome", nullptr, kFlags)) contents(model, words, commands);
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace aucast::gui
