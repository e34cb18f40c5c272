#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>

#include "client/gui/panels/panels.h"
#include "client/gui/texts/texts.h"

namespace aucast::gui {
namespace {

/// Draws a sentence over the face with its lower edge at `bottom`, and sets `bottom` to its upper
/// edge. Returns whether it was clicked.
bool sentence(const Look& look, const char* id, const Notice& notice, float width, float& bottom) {
  ImGui::SetNextWindowPos(ImVec2(width / 2, bottom), ImGuiCond_Always, ImVec2(0.5F, 1));
  // The size is given: ImGui would find it one frame late, and cut a text that is longer than the
  // last until the next frame, which may be long in coming.
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  const float wrap = std::max(width - 60 * look.scale, 200 * look.scale) - padding.x;
  const ImVec2 text_size = ImGui::CalcTextSize(notice.text.c_str(), nullptr, false, wrap);
  ImGui::SetNextWindowSize(ImVec2(text_size.x + 2 * padding.x, text_size.y + 2 * padding.y));
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoFocusOnAppearing;
  bool clicked = false;
  const FloatingStyle floating(look);
  if (ImGui::Begin(id, nullptr, kFlags)) {
    const unsigned colour = notice.bad ? colour_of(Tone::Bad) : ImGui::GetColorU32(ImGuiCol_Text);
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::PushTextWrapPos(padding.x + wrap);
    ImGui::TextUnformatted(notice.text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    clicked = ImGui::IsWindowHovered() && ImGui::IsMouseClicked(0);
    bottom -= ImGui::GetWindowHeight() + 8 * look.scale;
  }
  ImGui::End();
  return clicked;
}

/// How the connection stands, where that is not what was asked for.
Notice of_connection(const PlayingView& playing) {
  const char* face = "";
  if (playing.stale) face = tr("notice.last_face");
  if (playing.eased) face = tr("notice.eased");
  std::string text = playing.detail;
  if (*face != 0) text += std::string(text.empty() ? "" : "\n") + face;
  if (!text.empty() || playing.ended_by.empty()) return {text, true};
  return {tr("notice.ended", playing.ended_by), false};
}

/// Names the server: the field of the address may name another one by now.
std::string again(const RemoteSettings& tried, int in_s) {
  const std::string server = server_text(tried);
  return in_s > 0 ? tr("notice.again", server, in_s) : tr("notice.again_now", server);
}

}  // namespace

float notices(const Look& look, const GuiModel& model, float width, float bar, NoticeForm& form,
              GuiCommands& commands) {
  const float lowest = ImGui::GetIO().DisplaySize.y - bar - 14 * look.scale;
  float bottom = lowest;
  if (!model.notice.text.empty() && sentence(look, "notice", model.notice, width, bottom)) {
    commands.push_back(CloseNotice{});
  }
  // What counts down stays the same notice.
  Notice now = of_connection(model.playing);
  if (now.text != form.closed) form.closed.clear();
  // What is said of a server that was given up is over when another one is named.
  const bool renamed = std::exchange(form.other_server, false);
  if (renamed && model.playing.activity == Activity::Over) form.closed = now.text;
  form.shown = form.closed.empty() ? now.text : "";
  if (form.shown.empty()) return bar + lowest - bottom;
  if (model.playing.tries_again)
    now.text += "\n" + again(model.remote_settings, model.playing.again_s);
  if (sentence(look, "trouble", now, width, bottom)) form.closed = form.shown;
  return bar + lowest - bottom;
}

}  // namespace aucast::gui
