#include <imgui.h>

#include <algorithm>
#include <string>

#include "client/gui/panels.h"
#include "client/gui/texts.h"

namespace aucast::gui {
namespace {

/// A sentence over the face, its lower edge at `bottom`, which is moved to its upper one. True when
/// it was clicked.
bool sentence(const Look& look, const char* id, const Notice& notice, float width, float& bottom) {
  ImGui::SetNextWindowPos(ImVec2(width / 2, bottom), ImGuiCond_Always, ImVec2(0.5F, 1));
  constexpr ImGuiWindowFlags kFlags =
      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
      ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_AlwaysAutoResize;
  bool clicked = false;
  const FloatingStyle floating(look);
  if (ImGui::Begin(id, nullptr, kFlags)) {
    const unsigned colour = notice.bad ? colour_of(Tone::Bad) : ImGui::GetColorU32(ImGuiCol_Text);
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::PushTextWrapPos(std::max(width - 60 * look.scale, 200 * look.scale));
    ImGui::TextUnformatted(notice.text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    clicked = ImGui::IsWindowHovered() && ImGui::IsMouseClicked(0);
    bottom -= ImGui::GetWindowHeight() + 8 * look.scale;
  }
  ImGui::End();
  return clicked;
}

std::string trouble_of(const RemoteView& remote) {
  std::string text = remote.detail;
  const char* face = "";
  if (remote.stale) face = tr("notice.last_face");
  if (remote.eased) face = tr("notice.eased");
  if (*face != 0) text += std::string(text.empty() ? "" : "\n") + face;
  return text;
}

}  // namespace

void notices(const Look& look, const GuiModel& model, float width, NoticeForm& form,
             GuiCommands& commands) {
  const float above = model.local.open ? kTransportHeight * look.scale : 0;
  float bottom = ImGui::GetIO().DisplaySize.y - above - 14 * look.scale;
  if (!model.notice.text.empty() && sentence(look, "notice", model.notice, width, bottom)) {
    commands.push_back(CloseNotice{});
  }
  const Notice trouble{trouble_of(model.remote), true};
  if (trouble.text != form.trouble) form.trouble.clear();
  if (trouble.text.empty() || !form.trouble.empty()) return;
  if (sentence(look, "trouble", trouble, width, bottom)) form.trouble = trouble.text;
}

}  // namespace aucast::gui
