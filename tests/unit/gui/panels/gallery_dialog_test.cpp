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
  for (float y = 40; y < 80 && ImGui::GetActiveID() != folder; y += 5) {
    click(dialog->Pos.x + dialog->Size.x / 2, dialog->Pos.y + y);
  }
  ASSERT_EQ(ImGui::GetActiveID(), folder);
  type("x");
  press(ImGuiKey_Enter);
  EXPECT_NE(ImGui::GetActiveID(), folder) << "the next key would replace the setting";
}

}  // namespace
}  // namespace aucast::gui
