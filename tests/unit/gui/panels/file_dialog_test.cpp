// The file dialog by keyboard.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <imgui.h>

#include "client/gui/widgets/widgets.h"
#include "tests/unit/gui/gui_by_hand.h"

namespace aucast::gui {
namespace {

class FileDialog : public GuiByHand {
 protected:
  static ImGuiWindow* dialog() { return ImGui::FindWindowByID(ImHashStr("###files")); }
  bool tab_to(const char* label) {
    for (int i = 0; i < 30; ++i) {
      if (focus() == dialog()->GetID(label)) return true;
      press(ImGuiKey_Tab);
    }
    return false;
  }
};

TEST_F(FileDialog, APathThatWasTypedIsOpenedByTheButtonToo) {
  model_.browser.open = true;
  model_.browser.purpose = Purpose::PlayStream;
  model_.browser.folder = "/tmp";
  frames(5);
  ASSERT_NE(dialog(), nullptr);
  EXPECT_FALSE(tab_to("Open")) << "nothing is chosen";
  ASSERT_TRUE(tab_to("##folder"));
  type("/data/table.csv");
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<ChooseFile>());
  EXPECT_EQ(asked<ChooseFile>()->file, "/data/table.csv");
  commands_.clear();
  model_.browser.problem = "say how many pictures a second there are";
  frames(3);
  model_.browser.problem.clear();
  ASSERT_TRUE(tab_to("Open"));
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<ChooseFile>());
  EXPECT_EQ(asked<ChooseFile>()->file, "/data/table.csv");
}

TEST_F(FileDialog, APathThatWasTypedIsNotLostOnTheWayToTheButton) {
  model_.browser.open = true;
  model_.browser.purpose = Purpose::PlayStream;
  model_.browser.folder = "/tmp";
  model_.browser.entries = {{"anger.txt", false}, {"fear.txt", false}};
  frames(5);
  ASSERT_TRUE(tab_to("##folder"));
  type("/data/table.csv");
  ASSERT_TRUE(tab_to("Open"));  // through the list
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<ChooseFile>());
  EXPECT_EQ(asked<ChooseFile>()->file, "/data/table.csv");
}

TEST_F(FileDialog, EnterOpensWhatWasClicked) {
  model_.browser.open = true;
  model_.browser.purpose = Purpose::ComposeStream;
  model_.browser.folder = "/tmp";
  model_.browser.entries = {{"anger.txt", false}, {"fear.txt", false}};
  frames(5);
  ASSERT_NE(dialog(), nullptr);
  for (float y = dialog()->Pos.y + 76; y < dialog()->Pos.y + 300 && commands_.empty(); y += 6) {
    click(dialog()->Pos.x + 60, y);
    frames(40);  // no double click
    press(ImGuiKey_Enter);
  }
  ASSERT_TRUE(asked<ChooseFile>());
  EXPECT_EQ(asked<ChooseFile>()->file, "anger.txt");
}

TEST_F(FileDialog, WhatIsWrongWithAFileIsNotSaidOfAnother) {
  model_.browser.open = true;
  model_.browser.purpose = Purpose::ComposeStream;
  model_.browser.folder = "/tmp";
  model_.browser.entries = {{"anger.txt", false}, {"fear.txt", false}};
  frames(5);
  const auto is_said = [&] {
    frames(2);
    const auto& vertices = dialog()->DrawList->VtxBuffer;
    return std::any_of(vertices.begin(), vertices.end(),
                       [](const ImDrawVert& vertex) { return vertex.col == colour_of(Tone::Bad); });
  };
  press(ImGuiKey_DownArrow);
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<ChooseFile>());
  EXPECT_EQ(asked<ChooseFile>()->file, "fear.txt");
  model_.browser.problem = "this is no stream";
  EXPECT_TRUE(is_said());
  press(ImGuiKey_UpArrow);
  EXPECT_FALSE(is_said()) << "another file is chosen";
  press(ImGuiKey_DownArrow);
  EXPECT_TRUE(is_said());
}

TEST_F(FileDialog, APathThatIsTypedAtOnceIsForItsField) {
  model_.browser.purpose = Purpose::PlayStream;
  model_.browser.folder = "/home";
  model_.browser.entries = {{"anger.txt", false}};
  model_.browser.open = true;
  ImGui::GetIO().AddInputCharactersUTF8("/da");
  frames(1);
  ASSERT_NE(dialog(), nullptr);
  EXPECT_EQ(ImGui::GetActiveID(), dialog()->GetID("##folder"));
  ImGui::GetIO().AddInputCharactersUTF8("ta/x.csv");
  frames(1);
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<ChooseFile>());
  EXPECT_EQ(asked<ChooseFile>()->file, "/data/x.csv");
  commands_.clear();
  model_.browser.open = false;
  frames(5);
  // All of it in one frame.
  model_.browser.open = true;
  ImGui::GetIO().AddInputCharactersUTF8("/data/y.csv");
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<ChooseFile>());
  EXPECT_EQ(asked<ChooseFile>()->file, "/data/y.csv");
}

TEST_F(FileDialog, APathInTheHomeFolderIsTypedAtOnceToo) {
  model_.browser.purpose = Purpose::PlayStream;
  model_.browser.folder = "/data";
  model_.browser.entries = {{"anger.txt", false}};
  model_.browser.open = true;
  frames(5);
  type("~");
  EXPECT_EQ(ImGui::GetActiveID(), dialog()->GetID("##folder"));
  type("/x.csv");
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<ChooseFile>());
  EXPECT_EQ(asked<ChooseFile>()->file, "~/x.csv");
}

TEST_F(FileDialog, HasTheKeysFromTheFrameInWhichItComes) {
  EXPECT_FALSE(gui_->wants_keys());
  model_.browser.open = true;
  gui_->expect(model_);
  EXPECT_TRUE(gui_->wants_keys());
  frames(5);
  model_.browser.open = false;
  frames(5);
  gui_->expect(model_);
  EXPECT_FALSE(gui_->wants_keys());
}

TEST_F(FileDialog, BackspaceGoesUpWhereNothingIsTyped) {
  model_.browser.open = true;
  model_.browser.purpose = Purpose::PlayStream;
  model_.browser.folder = "/data/streams";
  model_.browser.entries = {{"anger.txt", false}};
  frames(5);
  press(ImGuiKey_Backspace);
  ASSERT_TRUE(asked<EnterFolder>());
  EXPECT_EQ(asked<EnterFolder>()->folder, "/data");
  commands_.clear();
  ASSERT_TRUE(tab_to("##folder"));
  type("/tmp/x");
  press(ImGuiKey_Backspace);
  EXPECT_FALSE(asked<EnterFolder>()) << "a letter is taken back";
}

TEST_F(FileDialog, ANameThatWasRefusedIsTypedAnew) {
  model_.browser.open = true;
  model_.browser.purpose = Purpose::SaveStream;
  model_.browser.folder = "/tmp";
  model_.browser.name = "composed.txt";
  frames(5);
  type("a/b/x.txt");
  model_.browser.problem = "there is no such folder";
  press(ImGuiKey_Enter);
  frames(3);
  EXPECT_EQ(ImGui::GetCurrentContext()->ActiveId, dialog()->GetID("##name"));
  commands_.clear();
  type("x.txt");
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<ChooseFile>());
  EXPECT_EQ(asked<ChooseFile>()->file, "x.txt");
}

}  // namespace
}  // namespace aucast::gui
