// What the panels write over the face.
#include <string>

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "tests/unit/gui/gui_by_hand.h"

namespace aucast::gui {
namespace {

class OverFace : public GuiByHand {
 protected:
  static bool is_there(const char* name) {
    const ImGuiWindow* const window = ImGui::FindWindowByName(name);
    return window != nullptr && window->Active;
  }
};

TEST_F(OverFace, NeitherTitleNorCaptionStaysWhenPlayingIsOver) {
  model_.spoken.title = "A talk";
  model_.spoken.caption = "Yes.";
  model_.playing.activity = Activity::Playing;
  frames(2);
  EXPECT_TRUE(is_there("title"));
  EXPECT_TRUE(is_there("caption"));
  model_.playing.activity = Activity::Over;
  frames(2);
  EXPECT_FALSE(is_there("title"));
  EXPECT_FALSE(is_there("caption"));
}

TEST_F(OverFace, WhatIsSaidOfAServerThatWasGivenUpGoesWhenAnotherOneIsNamed) {
  model_.playing.detail = "cannot reach lecture.example.org: its name is not known";
  model_.playing.activity = Activity::Connecting;
  frames(2);
  ASSERT_TRUE(go_to("##address"));
  type("a");
  EXPECT_TRUE(gui_->close_notice()) << "that one is still tried";
  model_.playing.detail = "cannot reach lecture.example.org: it has no address";
  model_.playing.activity = Activity::Over;
  frames(2);
  ASSERT_TRUE(ImGui::FindWindowByName("trouble")->Active);
  type("b");
  EXPECT_FALSE(gui_->close_notice());
}

}  // namespace
}  // namespace aucast::gui
