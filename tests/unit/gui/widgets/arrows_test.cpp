// What is dragged with the mouse, and what is typed in fields, by keyboard alone.

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "client/gui/texts/texts.h"
#include "tests/unit/gui/gui_by_hand.h"

namespace aucast::gui {
namespace {

using Arrows = GuiByHand;

/// Of the bar under the face.
bool go_to_seek_bar(const std::function<void()>& tab) {
  const ImGuiWindow* const bar = ImGui::FindWindowByName("transport");
  if (bar == nullptr) return false;
  const ImGuiID seek = ImHashStr("##seek", 0, bar->ID);
  tab();
  for (int i = 0; i < 200 && ImGui::GetCurrentContext()->NavId != seek; ++i) tab();
  return ImGui::GetCurrentContext()->NavId == seek;
}

TEST_F(Arrows, MoveTheFaceOnTheEmotionPadOnceItIsTaken) {
  model_.composer.pad = std::make_shared<const std::vector<PadPoint>>(
      std::vector<PadPoint>{{"Happiness", 0.8F, 0.02F, {}}});
  model_.composer.pad_at = {0.75F, 0.0F};
  ASSERT_TRUE(go_to_tab("Compose"));
  ASSERT_TRUE(go_to("##pad"));
  commands_.clear();
  press(ImGuiKey_Space);
  EXPECT_FALSE(asked<ComposeMood>()) << "the pointer is elsewhere";
  press(ImGuiKey_RightArrow);
  const auto mood = asked<ComposeMood>();
  ASSERT_TRUE(mood);
  EXPECT_FLOAT_EQ(mood->x, 0.8F);
  EXPECT_FLOAT_EQ(mood->y, 0.02F) << "close to a prototype it is meant";
  EXPECT_FALSE(mood->continued);
  EXPECT_EQ(focus(), id_of("##pad"));
  commands_.clear();
  press(ImGuiKey_DownArrow);
  ASSERT_TRUE(asked<ComposeMood>());
  EXPECT_LT(asked<ComposeMood>()->y, 0);
  EXPECT_TRUE(asked<ComposeMood>()->continued) << "one step for undo";
  press(ImGuiKey_Space);
  commands_.clear();
  press(ImGuiKey_RightArrow);
  EXPECT_FALSE(asked<ComposeMood>()) << "it was let go";
}

TEST_F(Arrows, SeekOnTheBarOnceItIsTaken) {
  play_something();
  ASSERT_TRUE(go_to_seek_bar([this] { press(ImGuiKey_Tab); }));
  press(ImGuiKey_Enter);
  press(ImGuiKey_LeftArrow);
  ASSERT_TRUE(asked<SeekBy>());
  EXPECT_EQ(asked<SeekBy>()->time, Milliseconds(-1'000));
  EXPECT_FALSE(asked<Seek>());
  commands_.clear();
  press(ImGuiKey_Enter);
  press(ImGuiKey_LeftArrow);
  EXPECT_FALSE(asked<SeekBy>()) << "it was let go";
}

TEST_F(Arrows, ManyCurvesAreFoldedUntilTheyAreWanted) {
  AuCurves many;
  for (int number = 1; number < 10; ++number) many.push_back({number, {0.5F}});
  model_.local.curves = std::make_shared<const AuCurves>(many);
  play_something();
  ASSERT_TRUE(go_to("Curves of 9 AUs###fold"));
  const float folded = contents()->ContentSize.y;
  press(ImGuiKey_Enter);
  EXPECT_GT(contents()->ContentSize.y, folded + 100);
  EXPECT_TRUE(go_to("##curves"));
}

TEST_F(Arrows, TheNameOfACurveHidesNothingOfIt) {
  model_.local.curves = std::make_shared<const AuCurves>(AuCurves{{6, {0.5F}}, {12, {1.0F}}});
  play_something();
  ASSERT_TRUE(go_to("##curves"));
  const ImU32 line = ImGui::GetColorU32(ImGuiCol_PlotLines);
  const ImU32 name = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  const ImVec2 no_letter = ImGui::GetIO().Fonts->TexUvWhitePixel;
  const ImRect item = ImGui::GetCurrentContext()->NavWindow->NavRectRel[ImGuiNavLayer_Main];
  const float top = contents()->DC.CursorStartPos.y + item.Min.y;
  const float height = item.GetHeight() / 2;
  float end_of_name = 0;
  float begin_of_line = height;
  for (const ImDrawVert& vertex : contents()->DrawList->VtxBuffer) {
    const float y = vertex.pos.y - top;
    if (y < 0 || y >= height) continue;  // of another row
    const bool letter = vertex.uv.x != no_letter.x || vertex.uv.y != no_letter.y;
    if (vertex.col == name && letter) end_of_name = std::max(end_of_name, y);
    if (vertex.col == line) begin_of_line = std::min(begin_of_line, y);
  }
  EXPECT_GT(end_of_name, 0);
  EXPECT_LT(end_of_name, begin_of_line);
  EXPECT_LT(begin_of_line, height);
}

TEST_F(Arrows, ReadCurvesFrameByFrameAndAuByAu) {
  model_.local.curves =
      std::make_shared<const AuCurves>(AuCurves{{6, {0.5F}}, {12, {1.0F}}, {26, {0.2F}}});
  play_something();
  ASSERT_TRUE(go_to("##curves"));
  press(ImGuiKey_Space);
  EXPECT_FALSE(asked<Seek>());
  press(ImGuiKey_RightArrow);
  ASSERT_TRUE(asked<StepFrame>());
  EXPECT_EQ(asked<StepFrame>()->direction, 1);
  const ImGuiWindow* const said = tooltip();
  ASSERT_NE(said, nullptr) << "which AU it is, and when";
  const float first = said->Pos.y;
  press(ImGuiKey_DownArrow);
  ASSERT_NE(tooltip(), nullptr);
  EXPECT_NE(tooltip()->Pos.y, first);
}

TEST_F(Arrows, LettersTypedAfterReturnInAFieldAreNoShortcuts) {
  ASSERT_TRUE(go_to_tab("Expression"));
  ASSERT_TRUE(go_to("##compound"));
  type("6,12");
  commands_.clear();
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<ShowAus>());
  EXPECT_EQ(asked<ShowAus>()->aus, "6,12");
  EXPECT_TRUE(gui_->wants_keys());
  type("4");
  press(ImGuiKey_Enter);
  EXPECT_EQ(command_if<ShowAus>(commands_.back())->aus, "4");
  EXPECT_TRUE(gui_->wants_keys());
  press(ImGuiKey_Escape);
  EXPECT_FALSE(gui_->wants_keys());
}

TEST_F(Arrows, ActionUnitsAreFoundWithSpacesBetweenThem) {
  model_.expressions.buttons.push_back({"Fear", "1,2,4", ExpressionKind::Other});
  model_.expressions.buttons.push_back({"Sadness", "1,4", ExpressionKind::Other});
  ASSERT_TRUE(go_to_tab("Expression"));
  ASSERT_TRUE(go_to("##more"));
  press(ImGuiKey_Enter);
  type("1 4");
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<ShowExpression>());
  EXPECT_EQ(asked<ShowExpression>()->index, 3U);
}

TEST_F(Arrows, ASettingThatWasTypedIsNotTypedOverByTheNextShortcut) {
  ASSERT_TRUE(go_to_tab("Camera"));
  ASSERT_TRUE(go_to("##source"));
  type("camera:/dev/video2");
  EXPECT_TRUE(gui_->wants_keys());
  press(ImGuiKey_Enter);
  EXPECT_FALSE(gui_->wants_keys());
}

TEST_F(Arrows, ANumberBeyondItsRangeIsCutAndThatIsSaid) {
  ASSERT_TRUE(go_to_tab("Expression"));
  const ImGuiID frames_field = ImHashStr("", 0, id_of("##frames"));
  for (int i = 0; i < 200 && focus() != frames_field; ++i) press(ImGuiKey_Tab);
  ASSERT_EQ(focus(), frames_field);
  type("499");
  frames(2);
  EXPECT_EQ(tooltip(), nullptr);
  type("9");
  frames(2);
  EXPECT_NE(tooltip(), nullptr);
  EXPECT_EQ(command_if<ChangeTransition>(commands_.back())->settings.frames, 500);
  press(ImGuiKey_Enter);
  frames(2);
  EXPECT_EQ(tooltip(), nullptr);
}

TEST_F(Arrows, TheNamesOfTheTabsAreWholeWithLargeLettersOnASmallScreen) {
  ImGui::GetIO().DisplaySize = ImVec2(800, 600);
  DisplayView display;
  display.settings.text_percent = 200;
  ASSERT_TRUE(gui_->prepare(display));
  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  frames(4);
  ImGuiContext& context = *ImGui::GetCurrentContext();
  ASSERT_EQ(context.TabBars.GetMapSize(), 1);
  const ImGuiTabBar* const bar = context.TabBars.TryGetMapData(0);
  ASSERT_NE(bar, nullptr);
  for (const ImGuiTabItem& tab : bar->Tabs) EXPECT_GE(tab.Width, tab.ContentWidth);
  EXPECT_LE(bar->WidthAllTabsIdeal, bar->BarRect.GetWidth() + 1);
}

}  // namespace
}  // namespace aucast::gui
