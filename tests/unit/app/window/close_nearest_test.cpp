#include "client/app/window/close_nearest.h"

#include <gtest/gtest.h>
#include <imgui.h>

namespace aucast::app {
namespace {

TEST(CloseNearest, ShowsThePanelAgainBeforeItEndsFullScreen) {
  gui::Gui panels(1.0F);
  ImGui::GetIO().DisplaySize = ImVec2(800, 600);
  const gui::GuiModel nothing;
  panels.toggle_panel();
  EXPECT_FALSE(close_nearest(panels, nothing, true).ends_full_screen);
  EXPECT_GT(panels.covered_width(), 0) << "the panel is there again";
  EXPECT_TRUE(close_nearest(panels, nothing, true).ends_full_screen);
  EXPECT_FALSE(close_nearest(panels, nothing, false).ends_full_screen);
}

TEST(CloseNearest, WhatIsNotSeenDoesNotHoldFullScreen) {
  gui::Gui panels(1.0F);
  ImGui::GetIO().DisplaySize = ImVec2(800, 600);
  panels.toggle_panel();
  panels.toggle_bare();
  panels.set_hidden(true);
  EXPECT_TRUE(close_nearest(panels, {}, true).ends_full_screen);
  panels.set_hidden(false);
  EXPECT_GT(panels.covered_width(), 0) << "the panel comes back with the window";
}

TEST(CloseNearest, ASentenceDoesNotHoldFullScreen) {
  gui::Gui panels(1.0F);
  ImGui::GetIO().DisplaySize = ImVec2(800, 600);
  gui::GuiModel model;
  model.notice.text = "picture saved";
  const Escaped whole = close_nearest(panels, model, true);
  EXPECT_TRUE(whole.ends_full_screen);
  ASSERT_EQ(whole.commands.size(), 1U);
  EXPECT_NE(gui::command_if<gui::CloseNotice>(whole.commands[0]), nullptr);
  panels.toggle_panel();
  const Escaped window = close_nearest(panels, model, false);
  EXPECT_EQ(window.commands.size(), 1U);
  EXPECT_EQ(panels.covered_width(), 0) << "one thing at a time";
}

}  // namespace
}  // namespace aucast::app
