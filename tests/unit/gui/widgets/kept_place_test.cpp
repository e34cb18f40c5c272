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
  read_on();
  ASSERT_NE(pointed_, 0U);
  const float scrolled = contents()->Scroll.y;
  ASSERT_GT(scrolled, 0);
  model_.video.recording = "/home/anna/pictures/a-face-that-is-recorded.mp4";
  frames(1);
  EXPECT_TRUE(gui_->rows_moved()) << "that frame is not shown";
  frames(1);
  EXPECT_FALSE(gui_->rows_moved());
  EXPECT_GT(contents()->Scroll.y, scrolled + 10);
  frames(1);
  EXPECT_EQ(ImGui::GetHoveredID(), pointed_);
  model_.video.recording.clear();
  frames(3);
  EXPECT_EQ(ImGui::GetHoveredID(), pointed_);
  EXPECT_EQ(contents()->Scroll.y, scrolled);
}

TEST_F(KeptPlaces, AtTheTopOfThePanelNothingIsScrolled) {
  ImGui::GetIO().DisplaySize = ImVec2(800, 420);
  frames(2);
  model_.video.recording = "/home/anna/pictures/a-face-that-is-recorded.mp4";
  frames(1);
  EXPECT_FALSE(gui_->rows_moved());
  frames(2);
  EXPECT_EQ(contents()->Scroll.y, 0);
}

}  // namespace
}  // namespace aucast::gui
