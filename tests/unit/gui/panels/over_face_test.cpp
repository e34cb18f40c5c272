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

TEST_F(OverFace, WithoutTheBarItsPlaceIsFree) {
  play_something();
  model_.spoken.caption = "Yes.";
  model_.playing.activity = Activity::Playing;
  model_.notice.text = "saved";
  frames(3);
  const float caption = rect_of("caption").Max.y;
  const float notice = rect_of("notice").Max.y;
  gui_->toggle_bare();
  frames(3);
  EXPECT_GT(rect_of("caption").Max.y, caption + 20);
  EXPECT_GT(rect_of("notice").Max.y, notice + 20);
}

TEST_F(OverFace, ACaptionMakesWayForNotices) {
  play_something();
  model_.spoken.caption = "Yes.";
  model_.playing.activity = Activity::Playing;
  frames(3);
  const float alone = rect_of("caption").Max.y;
  model_.notice.text = "saved";
  frames(3);
  const ImRect notice = rect_of("notice");
  EXPECT_LT(rect_of("caption").Max.y, notice.Min.y);
  model_.playing.detail = "the server has not been heard of for 5 s";
  frames(3);
  EXPECT_LT(rect_of("caption").Max.y, rect_of("trouble").Min.y);
  EXPECT_EQ(rect_of("notice").Max.y, notice.Max.y) << "what can be clicked stays";
  model_.playing.detail.clear();
  model_.notice.text.clear();
  frames(3);
  EXPECT_EQ(rect_of("caption").Max.y, alone);
}

TEST_F(OverFace, ANoticeIsWholeInItsFirstPicture) {
  model_.notice.text = "saved";
  frames(3);
  model_.notice.text = "AU90 saved in /home/somebody/.local/share/aucast/faces/default/aus.toml";
  frames(1);
  const ImRect first = rect_of("notice");
  frames(3);
  EXPECT_EQ(first.GetWidth(), rect_of("notice").GetWidth());
  EXPECT_EQ(first.GetHeight(), rect_of("notice").GetHeight());
  const ImGuiWindow* const notice = ImGui::FindWindowByName("notice");
  EXPECT_LE(notice->ContentSize.x, notice->InnerRect.GetWidth());
}

TEST_F(OverFace, TheQuestionOnLeavingFitsWithLargeLetters) {
  ImGui::GetIO().DisplaySize = ImVec2(700, 500);
  model_.display.settings.text_percent = 200;
  ASSERT_TRUE(gui_->prepare(model_.display));
  model_.editor.unsaved = true;
  model_.editor.au = 12;
  model_.asks_to_leave = true;
  frames(4);
  const auto question = [] { return ImGui::FindWindowByID(ImHashStr("###leave")); };
  ASSERT_NE(question(), nullptr);
  EXPECT_TRUE(ImRect(0, 0, 700, 500).Contains(question()->Rect()));
  EXPECT_LE(question()->ContentSize.x, question()->InnerRect.GetWidth()) << "no text is cut";
  const float before = question()->Size.y;
  model_.composer.unsaved = true;
  frames(4);
  EXPECT_GT(question()->Size.y, before) << "the stream is named too";
}

TEST_F(OverFace, TheQuestionOnLeavingHasItsAnswersInOneRowAndStaysByEnter) {
  model_.composer.unsaved = true;
  model_.asks_to_leave = true;
  frames(4);
  const ImGuiWindow* const question = ImGui::FindWindowByID(ImHashStr("###leave"));
  ASSERT_NE(question, nullptr);
  const ImRect& answer = question->NavRectRel[0];  // that has the focus
  const ImRect stay = answer;
  press(ImGuiKey_Tab);
  EXPECT_EQ(focus(), ImHashStr("Save", 0, question->ID));
  EXPECT_EQ(answer.Min.y, stay.Min.y);
  EXPECT_FLOAT_EQ(answer.GetWidth(), stay.GetWidth());
  press(ImGuiKey_Tab, true);
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<Leave>());
  EXPECT_FALSE(asked<Leave>()->really);
}

TEST_F(OverFace, TheQuestionOnLeavingNamesWhatIsBeingMade) {
  model_.gallery.running = true;
  model_.gallery.settings.folder = "/pictures/gallery";
  model_.asks_to_leave = true;
  frames(4);
  const ImGuiWindow* const question = ImGui::FindWindowByID(ImHashStr("###leave"));
  ASSERT_NE(question, nullptr);
  const float one = question->Size.y;
  model_.exported.file = "/pictures/face.glb";
  frames(4);
  EXPECT_GT(question->Size.y, one) << "the file is named too";
  for (int i = 0; i < 6; ++i) {
    press(ImGuiKey_Tab);
    EXPECT_NE(focus(), ImHashStr("Save", 0, question->ID)) << "there is nothing to save";
  }
}

TEST_F(OverFace, TheQuestionOnLeavingStandsAloneOverAnOpenDialog) {
  model_.browser.open = true;
  model_.browser.folder = "/streams";
  frames(4);
  model_.asks_to_leave = true;
  frames(4);
  const ImGuiWindow* const question = ImGui::FindWindowByID(ImHashStr("###leave"));
  ASSERT_NE(question, nullptr);
  EXPECT_TRUE(question->Active);
  EXPECT_FALSE(question->Appearing) << "it can be answered";
  model_.asks_to_leave = false;
  frames(4);
  const ImGuiWindow* const dialog = ImGui::FindWindowByID(ImHashStr("###files"));
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(dialog->Active) << "it was not closed by the question";
}

TEST_F(OverFace, SavingIsNotOfferedWhenSomethingStaysUnsaved) {
  const auto saves = [this] {
    frames(4);
    const ImGuiWindow* const question = ImGui::FindWindowByID(ImHashStr("###leave"));
    commands_.clear();
    for (int i = 0; i < 6 && !asked<Leave>(); ++i) {
      press(ImGuiKey_Tab);
      if (focus() == ImHashStr("Save", 0, question->ID)) press(ImGuiKey_Enter);
    }
    return asked<Leave>() && asked<Leave>()->saves;
  };
  model_.asks_to_leave = true;
  model_.editor.unsaved = true;
  model_.editor.au = 2;
  model_.editor.names = {{77, "yawn"}};
  EXPECT_FALSE(saves()) << "the name is another AU's";
  model_.editor.au = 77;
  EXPECT_TRUE(saves());
}

TEST_F(OverFace, SavingSaysWhyItIsNotOfferedOnLeaving) {
  model_.asks_to_leave = true;
  model_.editor.unsaved = true;
  const auto said = [this] {
    point_at(1, 1);
    frames(4);
    const ImGuiWindow* const question = ImGui::FindWindowByID(ImHashStr("###leave"));
    // "Stay" has the focus; "Save" is the next.
    const ImRect stay = question->NavRectRel[0];
    const ImVec2 origin = question->DC.CursorStartPos;
    point_at(origin.x + stay.Max.x + stay.GetWidth() / 2, origin.y + stay.GetCenter().y);
    return tooltip() != nullptr ? tooltip()->ContentSize.x : 0.0F;
  };
  const float of_number = said();
  EXPECT_GT(of_number, 0) << "an expression is no AU";
  model_.editor.au = 2;
  EXPECT_EQ(said(), 0);
  model_.editor.names = {{77, "yawn"}};
  const float of_names = said();
  EXPECT_GT(of_names, 0);
  EXPECT_NE(of_names, of_number) << "another reason";
}

TEST_F(OverFace, SaveSaysWhyItIsGreyWithoutAKeyframe) {
  ASSERT_TRUE(go_to_tab("Compose"));
  const auto tips_of_row = [this] {
    int tips = 0;
    for (float y = 72; y < 160; y += 12) {
      point_at(ImGui::GetIO().DisplaySize.x - 60, y);  // the last button of the first row
      tips += static_cast<int>(tooltip() != nullptr);
    }
    return tips;
  };
  EXPECT_GT(tips_of_row(), 0);
  model_.composer.rows =
      std::make_shared<const std::vector<TimelineRow>>(std::vector<TimelineRow>{{"12", "500 ms"}});
  EXPECT_EQ(tips_of_row(), 0);
}

}  // namespace
}  // namespace aucast::gui
