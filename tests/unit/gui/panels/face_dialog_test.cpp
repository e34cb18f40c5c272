// What is asked before a face of the user's own is made, renamed or deleted.
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <imgui.h>

#include "tests/unit/gui/gui_by_hand.h"

namespace aucast::gui {
namespace {

class FaceQuestions : public GuiByHand {
 protected:
  void SetUp() override {
    GuiByHand::SetUp();
    show("/own/anna");
    ASSERT_TRUE(go_to_tab("View"));
  }
  void show(const char* folder) {
    model_.faces.entries = std::make_shared<const std::vector<FaceEntry>>(
        std::vector<FaceEntry>{{"default", "/shipped/default", FaceKind::Shipped},
                               {"anna", "/own/anna", FaceKind::Own},
                               {"anna 2", "/own/anna 2", FaceKind::Own}});
    model_.faces.shown = folder;
    frames(3);
  }
  void use(const char* button) {
    press(ImGuiKey_Tab);  // behind Esc it is not seen
    ASSERT_TRUE(go_to(button)) << button;
    press(ImGuiKey_Enter);
    frames(3);
  }
  static ImGuiWindow* question() {
    ImGuiWindow* const window = ImGui::FindWindowByID(ImHashStr("###face"));
    return window != nullptr && window->Active ? window : nullptr;
  }
  /// Tab until a button of the question has the focus, then Enter.
  void answer(const char* button) {
    ASSERT_NE(question(), nullptr);
    for (int i = 0; i < 20 && focus() != question()->GetID(button); ++i) press(ImGuiKey_Tab);
    ASSERT_EQ(focus(), question()->GetID(button)) << button;
    press(ImGuiKey_Enter);
    frames(2);
  }
};

TEST_F(FaceQuestions, AFaceIsDeletedOnlyByAnAnswer) {
  use("Delete...");
  EXPECT_TRUE(gui_->wants_keys());
  EXPECT_FALSE(asked<DeleteFace>());
  answer("Cancel");
  EXPECT_EQ(question(), nullptr);
  EXPECT_FALSE(asked<DeleteFace>());
  use("Delete...");
  press(ImGuiKey_Escape);
  frames(2);
  EXPECT_EQ(question(), nullptr);
  EXPECT_FALSE(asked<DeleteFace>());
  use("Delete...");
  answer("Delete");
  EXPECT_EQ(question(), nullptr);
  ASSERT_TRUE(asked<DeleteFace>());
  EXPECT_EQ(asked<DeleteFace>()->folder, "/own/anna");
}

TEST_F(FaceQuestions, ACopyIsOfferedANameThatIsFreeAndAnotherOneIsTyped) {
  use("Copy...");
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<CopyFace>());
  EXPECT_EQ(asked<CopyFace>()->folder, "/own/anna");
  EXPECT_EQ(asked<CopyFace>()->name, "anna 3");
  commands_.clear();
  use("Copy...");
  type(" berta ");
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<CopyFace>());
  EXPECT_EQ(asked<CopyFace>()->name, "berta") << "typed in place of what was offered";
  EXPECT_EQ(question(), nullptr);
}

TEST_F(FaceQuestions, ANameThatCannotBeTakenIsNotTaken) {
  for (const char* name : {"anna 2", "default", "a/b", "."}) {
    use("Rename...");
    type(name);
    press(ImGuiKey_Enter);
    EXPECT_FALSE(asked<RenameFace>()) << name;
    EXPECT_NE(question(), nullptr) << "it can be corrected";
    press(ImGuiKey_Escape);
    press(ImGuiKey_Escape);
    frames(2);
    EXPECT_EQ(question(), nullptr);
  }
  use("Rename...");
  press(ImGuiKey_Enter);
  EXPECT_FALSE(asked<RenameFace>()) << "it has that name";
  type("berta");
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<RenameFace>());
  EXPECT_EQ(asked<RenameFace>()->folder, "/own/anna");
  EXPECT_EQ(asked<RenameFace>()->name, "berta");
}

TEST_F(FaceQuestions, AFaceWhoseNameIsWrongForACopyIsCopiedByAnotherName) {
  model_.faces.entries = std::make_shared<const std::vector<FaceEntry>>(
      std::vector<FaceEntry>{{"a\nb", "/own/odd", FaceKind::Own}});
  model_.faces.shown = "/own/odd";
  frames(3);
  use("Copy...");
  ASSERT_NE(question(), nullptr);
  press(ImGuiKey_Enter);
  EXPECT_FALSE(asked<CopyFace>()) << "what was offered has its letters";
  type("berta");
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<CopyFace>());
  EXPECT_EQ(asked<CopyFace>()->name, "berta");
}

TEST_F(FaceQuestions, AShippedFaceIsCopiedOnly) {
  show("/shipped/default");
  EXPECT_FALSE(go_to("Rename..."));
  EXPECT_FALSE(go_to("Delete..."));
  use("Copy...");
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<CopyFace>());
  EXPECT_EQ(asked<CopyFace>()->name, "default 2");
}

TEST_F(FaceQuestions, AQuestionAboutAFaceThatIsGoneGoesToo) {
  use("Delete...");
  ASSERT_NE(question(), nullptr);
  model_.faces.entries = std::make_shared<const std::vector<FaceEntry>>();
  frames(3);
  EXPECT_EQ(question(), nullptr);
  EXPECT_FALSE(gui_->wants_keys());
}

TEST_F(FaceQuestions, TheyFitWithLargeLetters) {
  ImGui::GetIO().DisplaySize = ImVec2(700, 500);
  model_.display.settings.text_percent = 200;
  ASSERT_TRUE(gui_->prepare(model_.display));
  use("Delete...");
  ASSERT_NE(question(), nullptr);
  frames(3);
  EXPECT_TRUE(ImRect(0, 0, 700, 500).Contains(question()->Rect()));
  EXPECT_LE(question()->ContentSize.x, question()->InnerRect.GetWidth()) << "no text is cut";
}

}  // namespace
}  // namespace aucast::gui
