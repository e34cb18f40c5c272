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
  const float padding = ImGui::GetStyle().WindowPadding.x;
  const float wrap = std::max(width - 60 * look.scale, 200 * look.scale) - padding;
  const FloatingStyle floating(look);
  if (notice.bad) ImGui::PushStyleColor(ImGuiCol_Text, colour_of(Tone::Bad));
  const float height = text_window(id, notice.text, ImVec2(width / 2, bottom), 1, wrap);
  if (notice.bad) ImGui::PopStyleColor();
  const bool clicked = ImGui::IsWindowHovered() && ImGui::IsMouseClicked(0);
  bottom -= height + 8 * look.scale;
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
