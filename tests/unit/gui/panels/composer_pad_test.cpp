// The emotion pad under the mouse.
#include <memory>
#include <vector>

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "tests/unit/gui/gui_by_hand.h"

namespace aucast::gui {
namespace {

class Pad : public GuiByHand {
 protected:
  void SetUp() override {
    GuiByHand::SetUp();
    model_.composer.pad = std::make_shared<const std::vector<PadPoint>>(
        std::vector<PadPoint>{{"Happiness", 0.5F, 0.5F, {}}});
    ASSERT_TRUE(go_to_tab("Compose"));
    ASSERT_TRUE(go_to("##pad"));
    const ImGuiWindow* const window = ImGui::GetCurrentContext()->NavWindow;
    pad_ = window->NavRectRel[0];
    pad_.Translate(window->Pos);
    const ImVec2 reach(pad_.GetWidth() / 2 - 14, pad_.GetHeight() / 2 - 14);
    dot_ = ImVec2(pad_.GetCenter().x + reach.x / 2, pad_.GetCenter().y - reach.y / 2);
  }
  void hold(ImVec2 at, bool down) {
    ImGui::GetIO().MousePos = at;
    frames(1);
    ImGui::GetIO().MouseDown[0] = down;
    frames(2);
  }

  ImRect pad_;
  ImVec2 dot_;
};

TEST_F(Pad, AClickOnAWordChoosesItsPrototype) {
  const ImVec2 word(dot_.x - 30, dot_.y);
  hold(word, true);
  ASSERT_TRUE(asked<ComposeMood>());
  EXPECT_EQ(asked<ComposeMood>()->x, 0.5F);
  EXPECT_EQ(asked<ComposeMood>()->y, 0.5F);
  commands_.clear();
  model_.composer.pad_at = {{0.5F, 0.5F}};
  hold(word, true);
  EXPECT_FALSE(asked<ComposeMood>()) << "while it is held";
  hold(ImVec2(word.x - 20, word.y), true);
  ASSERT_TRUE(asked<ComposeMood>()) << "dragged, it is a place";
  EXPECT_LT(asked<ComposeMood>()->x, 0.5F);
  hold(word, false);
}

TEST_F(Pad, WhoComesBackMayTakeWhatTheFaceShows) {
  model_.composer.aside = true;
  model_.composer.can_take = true;
  model_.playing.activity = Activity::Over;
  ASSERT_TRUE(go_to_tab("View"));
  commands_.clear();
  ASSERT_TRUE(go_to_tab("Compose"));
  EXPECT_FALSE(asked<ShowComposed>()) << "the face to be taken stays";
  ASSERT_TRUE(go_to(tr("compose.take")));
  press(ImGuiKey_Enter);
  EXPECT_TRUE(asked<ComposeShown>());
  EXPECT_FALSE(asked<ShowComposed>());
  ASSERT_TRUE(go_to("###composed"));
  press(ImGuiKey_Enter);
  EXPECT_TRUE(asked<ShowComposed>());
}

}  // namespace
}  // namespace aucast::gui
