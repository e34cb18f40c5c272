// Windows of any size, with letters of any size: ImGui aborts where a size comes out as nothing.
#include <memory>
#include <vector>

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "tests/unit/gui/gui_by_hand.h"

namespace aucast::gui {
namespace {

class NarrowWindow : public GuiByHand {
 protected:
  void SetUp() override {
    GuiByHand::SetUp();
    play_something();
    model_.local.curves = std::make_shared<const AuCurves>(AuCurves{{12, {1}}, {51, {0.5F}}});
    model_.playing.activity = Activity::Playing;
    model_.playing.au_history = {{12, {0, 0.5F, 1}}};
    model_.playing.aus = {{"51", "Head Turn Left", 100, 60, "opposition"}};
    model_.sound.there = true;
    model_.spoken.caption = "Yes.";
    model_.notice.text = "saved";
    model_.composer.rows =
        std::make_shared<const std::vector<TimelineRow>>(std::vector<TimelineRow>{{"12", "1 ms"}});
    model_.editor.groups = {{"Mouth", {{"zygomaticus major", 2, 0, 1, 0.5F, 0.5F}}}};
    frames(3);
  }
  /// Draws it in ever smaller windows, with the pointer in the middle, then in a usual one.
  void shrink() {
    for (int side = 480; side > 0; side -= side > 240 ? 40 : 1) {
      SCOPED_TRACE(side);
      const auto size = static_cast<float>(side);
      ImGui::GetIO().DisplaySize = ImVec2(size, 800);
      ImGui::GetIO().MousePos = ImVec2(size / 2, 400);
      frames(2);
      ImGui::GetIO().DisplaySize = ImVec2(size, size);
      frames(1);
    }
    ImGui::GetIO().DisplaySize = ImVec2(800, 800);
    frames(3);
  }
  void shrink_all_tabs() {
    for (const char* const tab : {"Play", "Expression", "Editor", "Compose", "View", "Camera"}) {
      SCOPED_TRACE(tab);
      ASSERT_TRUE(go_to_tab(tab));
      shrink();
    }
  }
  /// Whether the window of this identity was in the last frame.
  static bool is_drawn(const char* id) {
    const ImGuiWindow* const window = ImGui::FindWindowByID(ImHashStr(id));
    return window != nullptr && window->Active;
  }
  void letters(int percent) {
    DisplayView display;
    display.settings.text_percent = percent;
    ASSERT_TRUE(gui_->prepare(display));
    use_by_hand(ImVec2(800, 800));  // the fonts are others
    frames(3);
  }
};

TEST_F(NarrowWindow, EveryTabIsDrawn) {
  shrink_all_tabs();
}

TEST_F(NarrowWindow, EveryTabIsDrawnWithLargeLetters) {
  letters(200);
  shrink_all_tabs();
}

TEST_F(NarrowWindow, EveryDialogIsDrawn) {
  gui_->toggle_keys();
  shrink();
  EXPECT_TRUE(is_drawn("###keys"));
  gui_->toggle_keys();
  model_.gallery.open = true;
  shrink();
  EXPECT_TRUE(is_drawn("###gallery"));
  EXPECT_FALSE(is_drawn("###keys"));
  model_.gallery.open = false;
  model_.browser.open = true;
  model_.browser.folder = "/tmp";
  model_.browser.entries = {{"anger.txt", false}, {"fear.txt", false}};
  shrink();
  EXPECT_TRUE(is_drawn("###files"));
  model_.asks_to_leave = true;
  model_.composer.unsaved = true;
  shrink();
  EXPECT_TRUE(is_drawn("###leave"));
  EXPECT_FALSE(is_drawn("###files")) << "of two questions the one about leaving comes first";
}

}  // namespace
}  // namespace aucast::gui
