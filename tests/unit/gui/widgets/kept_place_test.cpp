// Rows that come and go above what the pointer is on.

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "client/gui/texts/texts.h"
#include "tests/unit/gui/gui_by_hand.h"

namespace aucast::gui {
namespace {

class KeptPlaces : public GuiByHand {
 protected:
  /// Scrolls the panel and points at a word of the choice of the mixer.
  void read_on() {
    ImGui::GetIO().DisplaySize = ImVec2(800, 420);
    const ImRect panel = rect_of("panel");
    point_at(panel.GetCenter().x, 300);
    ImGui::GetIO().MouseWheel = -4;
    frames(1);
    ImGui::GetIO().MouseWheel = 0;
    const ImGuiID word = ImHashStr(tr("play.maximum"), 0, id_of("mixer"));
    for (float y = 380; y > 100 && pointed_ == 0; y -= 4) {
      point_at(panel.Min.x + 200, y);
      if (ImGui::GetHoveredID() == word) pointed_ = word;
    }
  }

  ImGuiID pointed_ = 0;
};

TEST_F(KeptPlaces, WhatThePointerIsOnStaysThere) {
  model_.playing.local = true;
  frames(2);
  read_on();
  ASSERT_NE(pointed_, 0U);
  const float scrolled = contents()->Scroll.y;
  ASSERT_GT(scrolled, 0);
  model_.playing.local = false;  // a server's stream has buffers
  frames(1);
  EXPECT_TRUE(gui_->rows_moved()) << "that frame is not shown";
  frames(1);
  EXPECT_FALSE(gui_->rows_moved());
  EXPECT_GT(contents()->Scroll.y, scrolled + 10);
  frames(1);
  EXPECT_EQ(ImGui::GetHoveredID(), pointed_);
  model_.playing.local = true;
  frames(3);
  EXPECT_EQ(ImGui::GetHoveredID(), pointed_);
  EXPECT_EQ(contents()->Scroll.y, scrolled);
}

TEST_F(KeptPlaces, AusThatComeAndGoMoveNothing) {
  model_.playing.keyframe = "keyframe 3";
  model_.playing.aus = {{"6", "Cheek Raiser", 40, 20, "opposition"},
                        {"12", "Lip Corner Puller", 80, 80, ""}};
  frames(4);
  const float before = contents()->ContentSize.y;
  model_.playing.aus = {{"12", "Lip Corner Puller", 20, 20, ""}};
  frames(4);
  EXPECT_EQ(contents()->ContentSize.y, before);
  model_.playing.aus.clear();
  frames(4);
  EXPECT_EQ(contents()->ContentSize.y, before) << "a neutral keyframe";
}

TEST_F(KeptPlaces, WhatIsBeingWrittenMovesNothing) {
  frames(4);
  const float before = contents()->ContentSize.y;
  model_.video.recording = "/home/anna/pictures/a-face-that-is-recorded.mp4";
  model_.video.completing = "/home/anna/pictures/the-one-before.mp4";
  model_.exported = {"/home/anna/pictures/face.glb", 40, false};
  model_.gallery.running = true;
  model_.onsets = "/home/anna/times.csv";
  frames(4);
  EXPECT_EQ(contents()->ContentSize.y, before);
}

TEST_F(KeptPlaces, AtTheTopOfThePanelNothingIsScrolled) {
  ImGui::GetIO().DisplaySize = ImVec2(800, 420);
  model_.playing.local = true;
  frames(2);
  model_.playing.local = false;
  frames(1);
  EXPECT_FALSE(gui_->rows_moved());
  frames(2);
  EXPECT_EQ(contents()->Scroll.y, 0);
}

TEST_F(KeptPlaces, AChartThatAClickMakesLargerIsSeenWholeAndStillUnderThePointer) {
  model_.playing.au_history = {{12, {0, 0.5F, 1}}};
  frames(3);
  const ImGuiWindow& panel = *contents();
  const float usual = panel.ContentSize.y;
  // The window ends where the panel's content does.
  ImGui::GetIO().DisplaySize.y = panel.Pos.y + usual + 40;
  frames(3);
  const auto click = [this] {
    ImGui::GetIO().MouseDown[0] = true;
    frames(1);
    ImGui::GetIO().MouseDown[0] = false;
    frames(4);
  };
  float y = panel.Pos.y + usual - 60;
  point_at(panel.Pos.x + 100, y);
  ASSERT_EQ(panel.Scroll.y, 0);
  click();
  const float more = panel.ContentSize.y - usual;
  ASSERT_GT(more, 100) << "the pointer is on the chart";
  EXPECT_GT(panel.Scroll.y, 0);
  click();
  EXPECT_EQ(panel.ContentSize.y, usual) << "the pointer is on it still";
}

}  // namespace
}  // namespace aucast::gui
