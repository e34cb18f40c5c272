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

TEST_F(GuiByHand, AGalleryWhoseDialogIsClosedIsStillToBeSeen) {
  const auto at_mark = [&] {
    const ImRect panel = rect_of("panel");
    const ImGuiID mark = ImGui::FindWindowByName("panel")->GetID("##gallery");
    for (float x = panel.Min.x + 150; x < panel.Max.x; x += 4) {
      point_at(x, panel.Min.y + 22);
      if (ImGui::GetHoveredID() == mark) return true;
    }
    return false;
  };
  EXPECT_FALSE(at_mark());
  model_.gallery.running = true;
  model_.gallery.drawn = 3;
  model_.gallery.total = 10;
  ASSERT_TRUE(at_mark());
  EXPECT_NE(tooltip(), nullptr) << "it says how far it is";
  click(ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y);
  ASSERT_TRUE(asked<GalleryCommand>());
  EXPECT_TRUE(std::holds_alternative<OpenGallery>(*asked<GalleryCommand>()));
  model_.gallery.open = true;
  frames(3);
  EXPECT_FALSE(at_mark()) << "the dialog says it";
}

}  // namespace
}  // namespace aucast::gui
