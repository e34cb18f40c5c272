#pragma once

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/gui/gui.h"

namespace aucast::gui {

inline GuiModel small_model() {
  GuiModel model;
  model.playing.state = "no connection";
  model.remote_settings.address = "lecture.example.org";
  model.known_aus = std::make_shared<const std::vector<AuEntry>>(
      std::vector<AuEntry>{{12, "Lip Corner Puller", "zygomaticus major 1", "A smile."}});
  model.expressions.buttons = {{"Happiness", "6,12"}, {"Anger", "4,5,7,23"}};
  model.composer.rows = std::make_shared<const std::vector<TimelineRow>>();
  model.composer.pad = std::make_shared<const std::vector<PadPoint>>();
  model.faces.entries = std::make_shared<const std::vector<FaceEntry>>();
  model.recent = {"10.0.0.7"};
  model.sample = "talk.txt";
  return model;
}

/// Sets up ImGui for a Gui that has no display: key numbers (ImGui's own), fonts, size and clock.
inline void use_by_hand(const ImVec2& size) {
  ImGuiIO& io = ImGui::GetIO();
  for (int key = 0; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = key;
  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  io.DisplaySize = size;
  io.DeltaTime = 1.0F / 60;
}

/// The panels without a display.
class GuiByHand : public testing::Test {
 protected:
  void SetUp() override {
    gui_ = std::make_unique<Gui>(1.0F);
    use_by_hand(ImVec2(800, 800));
    frames(3);
  }

  void frames(int count) {
    for (int i = 0; i < count; ++i) gui_->draw(model_, commands_);
  }
  void press(ImGuiKey key, bool shift = false) {
    ImGuiIO& io = ImGui::GetIO();
    io.KeyShift = shift;
    io.KeysDown[key] = true;
    frames(1);
    io.KeysDown[key] = false;
    frames(3);
    io.KeyShift = false;
  }
  void play_something() {
    model_.local.open = true;
    model_.local.total = std::chrono::seconds(10);
    model_.local.ends =
        std::make_shared<const std::vector<Duration>>(std::vector<Duration>{model_.local.total});
    frames(3);
  }
  void type(const char* text) {
    ImGui::GetIO().AddInputCharactersUTF8(text);
    frames(3);
  }
  static ImGuiID focus() { return ImGui::GetCurrentContext()->NavId; }
  static ImGuiWindow* contents() {
    for (ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
      if (std::string(window->Name).find("/contents_") != std::string::npos && window->WasActive) {
        return window;
      }
    }
    return nullptr;
  }
  static ImGuiID id_of(const char* label) {
    ImGuiWindow* const window = contents();
    return window == nullptr ? 0 : window->GetID(label);
  }
  /// Presses Tab until the control with this label has the focus; false when it never has.
  bool go_to(const char* label) {
    for (int i = 0; i < 200; ++i) {
      if (focus() == id_of(label)) return true;
      press(ImGuiKey_Tab);
    }
    return false;
  }
  bool go_to_tab(const char* name) {
    ImGuiTabBar* bar = nullptr;
    ImGuiContext& context = *ImGui::GetCurrentContext();
    for (int i = 0; i < context.TabBars.GetMapSize(); ++i) bar = context.TabBars.TryGetMapData(i);
    if (bar == nullptr) return false;
    for (int i = 0; i < 200; ++i) {
      for (const ImGuiTabItem& item : bar->Tabs) {
        const bool meant = std::string(bar->GetTabName(&item)).starts_with(name);
        if (!meant || item.ID != focus()) continue;
        press(ImGuiKey_Enter);
        frames(3);
        return bar->SelectedTabId == item.ID;
      }
      press(ImGuiKey_Tab);
    }
    return false;
  }
  /// The tooltip that is shown at this moment; null: none.
  static const ImGuiWindow* tooltip() {
    const ImGuiWindow* const window = ImGui::FindWindowByName("##Tooltip_00");
    return window != nullptr && window->Active && !window->Hidden ? window : nullptr;
  }
  static ImRect rect_of(const char* name) {
    const ImGuiWindow* const window = ImGui::FindWindowByName(name);
    return window == nullptr ? ImRect() : window->Rect();
  }
  void click(float x, float y) {
    ImGui::GetIO().MousePos = ImVec2(x, y);
    frames(1);
    for (const bool down : {true, false}) {
      ImGui::GetIO().MouseDown[0] = down;
      frames(2);
    }
  }
  void point_at(float x, float y) {
    ImGui::GetIO().MousePos = ImVec2(x, y);
    frames(3);
  }
  template <typename Command>
  std::optional<Command> asked() {
    for (const GuiCommand& command : commands_) {
      if (const auto* found = command_if<Command>(command)) return *found;
    }
    return std::nullopt;
  }

  GuiModel model_ = small_model();
  GuiCommands commands_;
  std::unique_ptr<Gui> gui_;
};

}  // namespace aucast::gui
