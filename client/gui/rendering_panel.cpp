#include <imgui.h>

#include <array>

#include "client/gui/panels.h"

namespace aucast::gui {
namespace {

constexpr std::array kSurfaces = {"Solid", "Wireframe", "Vertices"};
constexpr std::array kGrounds = {"Studio", "Black", "Grey", "White"};

}  // namespace

void rendering_panel(const Look& look, const GuiModel& model, GuiCommands& commands) {
  RenderingSettings settings = model.rendering.settings;
  heading(look, "Camera");
  if (wide_button("Front", 0, 3, true)) commands.push_back(LookFrom{View::Front});
  if (wide_button("Three-quarter", 1, 3, true)) commands.push_back(LookFrom{View::ThreeQuarter});
  if (wide_button("Profile", 2, 3, true)) commands.push_back(LookFrom{View::Profile});
  quiet_text("The left mouse button turns the face, the right one moves it, the wheel zooms.");

  heading(look, "Picture");
  bool changed = false;
  label(look, "Face");
  int surface = static_cast<int>(settings.surface);
  if (choice("surface", kSurfaces, surface)) {
    settings.surface = static_cast<Surface>(surface);
    changed = true;
  }
  label(look, "Background");
  int ground = static_cast<int>(settings.ground);
  if (choice("ground", kGrounds, ground)) {
    settings.ground = static_cast<Ground>(ground);
    changed = true;
  }
  label(look, "Blinking");
  changed |= ImGui::Checkbox("##blinking", &settings.blinking);
  if (changed) commands.push_back(ChangeRendering{settings});

  heading(look, "Pace");
  quiet_text(model.rendering.pace.empty() ? "Nothing has moved yet." : model.rendering.pace);
}

}  // namespace aucast::gui
