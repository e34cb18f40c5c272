// The gallery's dialog by mouse and keyboard.
#include <gtest/gtest.h>
#include <imgui.h>

#include "tests/unit/gui/gui_by_hand.h"

namespace aucast::gui {
namespace {

TEST_F(GuiByHand, EnterEndsAFieldOfTheGallery) {
  model_.gallery.open = true;
  model_.gallery.settings.folder = "/tmp/faces";
  frames(5);
  const ImGuiWindow* const dialog = ImGui::FindWindowByID(ImHashStr("###gallery"));
  ASSERT_NE(dialog, nullptr);
  const ImGuiID folder = ImHashStr("##folder", 0, dialog->ID);
  ImGuiIO& io = ImGui::GetIO();
  for (float y = 40; y < 80 && ImGui::GetActiveID() != folder; y += 5) {
    io.MousePos = ImVec2(dialog->Pos.x + dialog->Size.x / 2, dialog->Pos.y + y);
    frames(1);
    for (const bool down : {true, false}) {
      io.MouseDown[0] = down;
      frames(2);
    }
  }
  ASSERT_EQ(ImGui::GetActiveID(), folder);
  type("x");
  press(ImGuiKey_Enter);
  EXPECT_NE(ImGui::GetActiveID(), folder) << "the next key would replace the setting";
}

}  // namespace
}  // namespace aucast::gui
