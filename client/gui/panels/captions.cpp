#include <imgui.h>

#include <algorithm>
#include <string>

#include "client/gui/panels/panels.h"

namespace aucast::gui {
namespace {

constexpr float kCaptionMargin = 24;
constexpr float kCaptionWidthMax = 640;

/// Text over the face, its middle at `x`; `anchor`: 0, `y` is its upper edge, 1, its lower.
void written(const Look& look, const char* id, const std::string& text, float x, float y,
             float anchor, float room) {
  const ImVec2 padding(12 * look.scale, 7 * look.scale);
  const float wrap = std::min(room, kCaptionWidthMax * look.scale) - padding.x;
  ImGui::SetNextWindowBgAlpha(0.72F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6 * look.scale);
  text_window(id, text, ImVec2(x, y), anchor, wrap,
              ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::End();
  ImGui::PopStyleVar(2);
}

}  // namespace

void captions(const Look& look, const GuiModel& model, float width, float taken) {
  const SpokenView& spoken = model.spoken;
  if (!spoken.shown || model.editor.active || model.composer.active) return;
  // Nothing is said any more.
  if (model.playing.activity == Activity::Over) return;
  const float margin = kCaptionMargin * look.scale;
  const float room = std::max(width - 4 * margin, 120 * look.scale);
  if (!spoken.title.empty()) {
    written(look, "title", spoken.title, width / 2, margin, 0, room);
  }
  if (spoken.caption.empty()) return;
  written(look, "caption", spoken.caption, width / 2, ImGui::GetIO().DisplaySize.y - taken - margin,
          1, room);
}

}  // namespace aucast::gui
