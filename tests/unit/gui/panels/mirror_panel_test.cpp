// What the Camera tab says in place of a picture.
#include <string>

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "client/gui/texts/texts.h"
#include "tests/unit/gui/gui_by_hand.h"

namespace aucast::gui {
namespace {

class MirrorPanel : public GuiByHand {
 protected:
  void SetUp() override {
    GuiByHand::SetUp();
    ASSERT_TRUE(go_to_tab("Camera"));
  }
  /// Where in the panel the first control below the picture is.
  float below() {
    if (!go_to(tr("camera.as_mirror"))) return -1;
    return ImGui::GetCurrentContext()->NavWindow->NavRectRel[0].Min.y;
  }
};

TEST_F(MirrorPanel, ALongReasonPushesDownWhatIsBelowAShortOneDoesNot) {
  const float usual = below();
  ASSERT_GT(usual, 0);
  model_.mirror.trouble = "no camera";
  frames(2);
  EXPECT_EQ(below(), usual);
  model_.mirror.trouble.clear();
  for (int line = 0; line < 40; ++line) model_.mirror.trouble += "line\n";
  frames(2);
  EXPECT_GT(below(), 40 * ImGui::GetFontSize());
}

}  // namespace
}  // namespace aucast::gui
