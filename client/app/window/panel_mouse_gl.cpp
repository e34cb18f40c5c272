#include <imgui.h>

#include <limits>

#include "client/app/window/panel_mouse.h"

namespace aucast::app {

void PanelMouse::take(const render::InputEvent& event) {
  using Kind = render::InputEvent::Kind;
  if (event.kind == Kind::Move) {
    x_ = event.x;
    y_ = event.y;
  } else if (event.kind == Kind::Leave) {
    // Who drags something may leave the window and come back.
    if (!buttons_[0] && !buttons_[1]) x_ = y_ = kNowhere;
  } else if (event.code >= 0 && static_cast<std::size_t>(event.code) < buttons_.size()) {
    buttons_[static_cast<std::size_t>(event.code)] = event.action != 0;
    if (event.action != 0) follows_ = double_clicks_.follows(event);
  }
}

void PanelMouse::hand_over() const {
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = ImVec2(static_cast<float>(x_), static_cast<float>(y_));
  for (std::size_t i = 0; i < buttons_.size(); ++i) io.MouseDown[i] = buttons_[i];
  // ImGui still looks whether the pointer has stayed where it was.
  io.MouseDoubleClickTime = follows_ ? std::numeric_limits<float>::max() : 0;
}

}  // namespace aucast::app
