#include "client/app/window_overlay.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>

namespace aucast::app {

WindowOverlay::WindowOverlay(render::Window& window) : window_(window), gui_(window.scale()) {
  ImGui_ImplGlfw_InitForOpenGL(window.native(), true);
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

WindowOverlay::~WindowOverlay() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
}

void WindowOverlay::draw(const gui::GuiModel& model, gui::GuiCommands& commands) {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  gui_.draw(model, commands);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  window_.set_taken(gui_.wants_pointer(), gui_.wants_keys());
}

int WindowOverlay::free_width(int framebuffer_width) const {
  const ImGuiIO& io = ImGui::GetIO();
  const float pixels = io.DisplayFramebufferScale.x > 0 ? io.DisplayFramebufferScale.x : 1;
  const auto covered = static_cast<int>(gui_.covered_width() * pixels);
  return std::max(1, framebuffer_width - covered);
}

}  // namespace aucast::app
