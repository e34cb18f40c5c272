#include "client/app/window_overlay.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <deque>
#include <set>

namespace aucast::app {

WindowOverlay::WindowOverlay(render::Window& window) : window_(window), gui_(window.scale()) {
  ImGui_ImplGlfw_InitForOpenGL(window.native(), false);  // feed() hands on what happens
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

WindowOverlay::~WindowOverlay() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
}

void WindowOverlay::draw(const gui::GuiModel& model, gui::GuiCommands& commands) {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  feed();
  gui_.draw(model, commands);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  window_.set_taken(gui_.wants_pointer(), gui_.wants_keys());
}

/// ImGui 1.86 looks at the state of mouse and keys once a frame, so that with slow drawing a tap
/// would be lost, or land where the pointer went afterwards. Hence a frame sees no more than one
/// change of a button or of a key, where the pointer was then; the rest waits.
void WindowOverlay::feed() {
  using Kind = render::InputEvent::Kind;
  std::deque<render::InputEvent>& input = window_.input();
  GLFWwindow* const window = window_.native();
  bool button_changed = false;
  std::set<int> keys_changed;
  for (; !input.empty(); input.pop_front()) {
    const render::InputEvent& event = input.front();
    const bool of_pointer = event.kind == Kind::Move || event.kind == Kind::Button;
    if (of_pointer && button_changed) break;
    if (event.kind == Kind::Key && !keys_changed.insert(event.code).second) break;
    switch (event.kind) {
      case Kind::Move:
        pointer_x_ = static_cast<float>(event.x);
        pointer_y_ = static_cast<float>(event.y);
        break;
      case Kind::Button:
        button_changed = true;
        if (event.code >= 0 && static_cast<std::size_t>(event.code) < buttons_.size()) {
          buttons_[static_cast<std::size_t>(event.code)] = event.action != 0;
        }
        break;
      case Kind::Scroll:
        ImGui_ImplGlfw_ScrollCallback(window, event.x, event.y);
        break;
      case Kind::Key:
        ImGui_ImplGlfw_KeyCallback(window, event.code, event.scancode, event.action,
                                   event.modifiers);
        break;
      case Kind::Character:
        ImGui_ImplGlfw_CharCallback(window, static_cast<unsigned>(event.code));
        break;
      case Kind::Focus:
        ImGui_ImplGlfw_WindowFocusCallback(window, event.code);
        break;
    }
  }
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = ImVec2(pointer_x_, pointer_y_);
  for (std::size_t i = 0; i < buttons_.size(); ++i) io.MouseDown[i] = buttons_[i];
}

bool WindowOverlay::input_waits() const {
  return !window_.input().empty();
}

int WindowOverlay::free_width(int framebuffer_width) const {
  const ImGuiIO& io = ImGui::GetIO();
  const float pixels = io.DisplayFramebufferScale.x > 0 ? io.DisplayFramebufferScale.x : 1;
  const auto covered = static_cast<int>(gui_.covered_width() * pixels);
  return std::max(1, framebuffer_width - covered);
}

}  // namespace aucast::app
