// What is said of a control while the pointer or the focus is on it.

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>
#include <set>
#include <string>

#include "client/gui/texts/texts.h"
#include "tests/unit/gui/gui_by_hand.h"

namespace aucast::gui {
namespace {

using Tips = GuiByHand;

TEST_F(Tips, WhatIsSaidOfAControlHidesNoOther) {
  const ImRect panel = rect_of("panel");
  int said = 0;
  for (float y = panel.Min.y; y < panel.Max.y; y += 12) {
    for (const float x : {panel.Min.x + 40, panel.Max.x - 40}) {
      point_at(x, y);
      if (tooltip() == nullptr) continue;
      ++said;
      EXPECT_FALSE(tooltip()->Rect().Overlaps(panel)) << x << " " << y;
      EXPECT_TRUE(ImRect(0, 0, 800, 800).Contains(tooltip()->Rect())) << x << " " << y;
    }
  }
  EXPECT_GT(said, 3);
  ASSERT_TRUE(go_to_tab("Expression"));
  said = 0;
  for (int i = 0; i < 60; ++i) {
    press(ImGuiKey_Tab);
    if (tooltip() == nullptr) continue;
    ++said;
    EXPECT_FALSE(tooltip()->Rect().Overlaps(panel));
  }
  EXPECT_GT(said, 1);
}

TEST_F(Tips, AWholeAddressFitsIntoItsFieldAndIsSaid) {
  model_.remote_settings.address = "lectures.faculty.university.example.org";
  model_.remote_settings.stream = "an-introduction-to-the-faces-of-monday";
  gui_.reset();  // one context at a time
  gui_ = std::make_unique<Gui>(1.0F);
  use_by_hand(ImVec2(800, 800));
  frames(3);
  const ImRect panel = rect_of("panel");
  ASSERT_TRUE(go_to("##address"));
  const ImRect field = ImGui::GetCurrentContext()->NavWindow->NavRectRel[ImGuiNavLayer_Main];
  EXPECT_GT(field.GetWidth(), 0.75F * panel.GetWidth());
  press(ImGuiKey_Escape);
  press(ImGuiKey_Escape);
  const ImVec2 from = contents()->Pos;
  point_at(from.x + field.GetCenter().x, from.y + field.GetCenter().y);
  ASSERT_NE(tooltip(), nullptr);
  const float lines = ImGui::CalcTextSize("a\na\na").y;
  EXPECT_GT(tooltip()->Rect().GetHeight(), lines) << "what was typed is longer than the field";
}

TEST_F(Tips, EveryWordOfAChoiceIsExplained) {
  ImGui::GetIO().DisplaySize = ImVec2(800, 1600);
  frames(3);
  const ImRect panel = rect_of("panel");
  ASSERT_TRUE(go_to(tr("play.next_connection")));
  press(ImGuiKey_Enter);
  press(ImGuiKey_Escape);
  const auto words_of = [](const char* choice, std::initializer_list<const char*> words) {
    std::set<ImGuiID> ids;
    for (const char* word : words) ids.insert(ImHashStr(word, 0, id_of(choice)));
    return ids;
  };
  std::set<ImGuiID> silent;
  silent.merge(words_of("behind", {tr("play.behind_sets"), tr("play.behind_live"),
                                   tr("play.behind_auto"), tr("play.behind_time")}));
  silent.merge(words_of("mixer", {tr("play.maximum"), tr("play.average")}));
  silent.merge(words_of("interpolation", {tr("panel.linear"), tr("panel.cosine")}));
  silent.merge(words_of("rules", {"facs", "kumar2010", tr("play.no_rules")}));
  ASSERT_EQ(silent.size(), 11U);
  for (float y = panel.Min.y; y < panel.Max.y; y += 12) {
    for (float x = panel.Min.x + 10; x < panel.Max.x; x += 20) {
      point_at(x, y);
      if (tooltip() != nullptr) silent.erase(ImGui::GetHoveredID());
    }
  }
  EXPECT_TRUE(silent.empty()) << silent.size() << " without a tooltip";
}

/// Controls of which nothing is said while the keyboard focus or the pointer is on them.
class SaidOfControls : public Tips {
 protected:
  /// All that Tab comes to; each by its text where that is its identity, else by its place.
  std::set<std::string> silent() {
    std::set<std::string> found;
    std::set<ImGuiID> seen;
    for (int i = 0; i < 250; ++i) {
      press(ImGuiKey_Tab);
      const ImGuiWindow* const window = ImGui::GetCurrentContext()->NavWindow;
      if (focus() == 0 || window == nullptr || !seen.insert(focus()).second) continue;
      // The cross of a dialog and the lines of its list are no words.
      const bool cross = window->NavRectRel[ImGuiNavLayer_Main].Max.y < 0;
      if (cross || std::string(window->Name).find("/entries_") != std::string::npos) continue;
      if (tooltip() == nullptr && !said_at_pointer(*window)) {
        found.insert(name_of(*window, focus()));
      }
    }
    EXPECT_GT(seen.size(), 3U);
    return found;
  }
  /// A field is in use as soon as it has the focus.
  bool said_at_pointer(const ImGuiWindow& window) {
    press(ImGuiKey_Escape);
    press(ImGuiKey_Escape);
    const ImVec2 place = window.NavRectRel[ImGuiNavLayer_Main].GetCenter();
    point_at(window.DC.CursorStartPos.x + place.x, window.DC.CursorStartPos.y + place.y);
    const bool said = tooltip() != nullptr;
    point_at(1, 400);
    return said;
  }
  static std::string name_of(const ImGuiWindow& window, ImGuiID id) {
    for (const EnglishText& one : kEnglish) {
      if (ImHashStr(one.text, 0, window.ID) == id) return one.key;
    }
    const ImRect place = window.NavRectRel[ImGuiNavLayer_Main];
    return std::string(window.Name) + " " + std::to_string(place.Min.x) + " " +
           std::to_string(place.Min.y);
  }
};

using Silent = std::set<std::string>;

TEST_F(SaidOfControls, OfThePanels) {
  model_.gallery.running = true;
  model_.video.recording = "face.mp4";
  model_.playing.keyframe = "keyframe 3";
  model_.playing.activity = Activity::Playing;
  model_.editor.can_undo = model_.editor.can_redo = model_.editor.unsaved = true;
  model_.editor.au = 12;
  model_.composer.can_undo = model_.composer.can_redo = model_.composer.unsaved = true;
  model_.composer.can_take = true;
  model_.display.languages = {{"en", "English"},
                              {"fr",
                               "Fran\xC3\xA7"
                               "ais"}};
  play_something();
  for (const char* tab : {"Play", "Expression", "Editor", "Compose", "View", "Camera"}) {
    SCOPED_TRACE(tab);
    ASSERT_TRUE(go_to_tab(tab));
    for (const char* part : {tr("play.next_connection"), tr("play.where")}) {
      if (std::string(tab) == "Play" && go_to(part)) press(ImGuiKey_Enter);
    }
    EXPECT_EQ(silent(), Silent{});
  }
}

TEST_F(SaidOfControls, OfTheDialogs) {
  ImGui::GetIO().DisplaySize = ImVec2(1400, 800);  // beside the panel
  model_.gallery.open = true;
  frames(3);
  EXPECT_EQ(silent(), Silent{});
  model_.gallery.open = false;
  model_.browser.open = true;
  model_.browser.folder = "/tmp";
  model_.browser.entries = {{"fear.txt", false}};
  frames(5);
  EXPECT_EQ(silent(), Silent{});
}

TEST_F(Tips, ANameThatATableCutsIsWholeInItsTip) {
  ImGui::GetIO().DisplaySize = ImVec2(800, 1600);
  const auto said_of = [&](const std::string& name) {
    model_.playing.aus = {{"97", name, 100, 100, ""}};
    frames(3);
    const ImRect panel = rect_of("panel");
    int said = 0;
    for (float y = contents()->DC.CursorMaxPos.y; y > contents()->DC.CursorMaxPos.y - 30; y -= 5) {
      point_at(panel.Min.x + 70, y);
      said += tooltip() == nullptr ? 0 : 1;
    }
    return said;
  };
  EXPECT_EQ(said_of("Short"), 0);
  EXPECT_GT(said_of("A name of one's own that has more words than a table of this width"), 0);
}

TEST_F(Tips, WhatIsSaidOfAButtonGoesWhenItIsClicked) {
  const ImRect panel = rect_of("panel");
  ImGuiIO& io = ImGui::GetIO();
  const ImGuiID gallery = id_of(tr("play.gallery"));
  ImVec2 at(panel.Max.x - 60, panel.Min.y);
  while (ImGui::GetHoveredID() != gallery && at.y < panel.Max.y) {
    at.y += 8;
    for (at.x = panel.Min.x + 40; at.x < panel.Max.x && ImGui::GetHoveredID() != gallery;
         at.x += 20) {
      point_at(at.x, at.y);
    }
  }
  at = io.MousePos;
  ASSERT_NE(tooltip(), nullptr);
  io.MouseDown[0] = true;
  frames(3);
  io.MouseDown[0] = false;
  frames(3);
  EXPECT_EQ(tooltip(), nullptr) << "the dialog that it opened may be there";
  point_at(10, 10);
  EXPECT_EQ(tooltip(), nullptr);
  press(ImGuiKey_Escape);
  point_at(at.x, at.y);
  EXPECT_NE(tooltip(), nullptr) << "told anew";
}

TEST_F(Tips, WhatIsSaidOfAButtonOfTheBarStandsAboveTheBar) {
  play_something();
  const ImRect bar = rect_of("transport");
  point_at(bar.Min.x + 30, bar.Min.y + 45);
  ASSERT_NE(tooltip(), nullptr);
  EXPECT_FALSE(tooltip()->Rect().Overlaps(bar));
}

TEST_F(Tips, WhatIsSaidOfAButtonOfABarOfThreeLinesStandsAboveTheBarToo) {
  model_.display.settings.text_percent = 120;
  ASSERT_TRUE(gui_->prepare(model_.display));
  play_something();
  const ImRect bar = rect_of("transport");
  point_at(bar.Min.x + 30, bar.Min.y + 90);
  ASSERT_NE(tooltip(), nullptr);
  EXPECT_FALSE(tooltip()->Rect().Overlaps(bar));
}

TEST_F(Tips, ATimeStandsOverTheBarOnlyWhereThePointerIs) {
  play_something();
  const ImRect bar = rect_of("transport");
  point_at(bar.GetCenter().x, bar.Min.y + 18);
  ASSERT_NE(tooltip(), nullptr);
  point_at(100, 100);
  EXPECT_EQ(tooltip(), nullptr);
  // As after a click on it, when keys are used next.
  press(ImGuiKey_Tab);
  ImGuiContext& context = *ImGui::GetCurrentContext();
  ImGuiWindow* const window = ImGui::FindWindowByName("transport");
  ImGui::FocusWindow(window);
  ImGui::SetFocusID(window->GetID("##seek"), window);
  context.NavDisableHighlight = true;
  context.NavDisableMouseHover = true;
  frames(3);
  EXPECT_EQ(tooltip(), nullptr);
}

class AuTips : public Tips {
 protected:
  /// Whether it is said of something in the table of AUs, so far from the right.
  bool is_said(const char* text, float from_right) {
    model_.playing.keyframe = "keyframe 3";
    frames(3);
    if (contents() == nullptr) return false;
    const ImRect seen = contents()->InnerRect;
    ImGui::SetScrollY(contents(), contents()->ScrollMax.y);
    frames(3);
    const float height = ImGui::CalcTextSize(text, nullptr, false, 26 * 15.0F).y;
    for (float y = seen.Min.y; y < seen.Max.y; y += 6) {
      point_at(seen.Max.x - from_right, y);
      const ImGuiWindow* const said = tooltip();
      if (said != nullptr && std::abs(said->ContentSize.y - height) < 1) return true;
    }
    return false;
  }
};

TEST_F(AuTips, ADifferenceOfReceivedAndShownIsExplainedAtTheirHeadings) {
  model_.playing.aus = {{"12", "Lip Corner Puller", 100, 60, ""}};
  EXPECT_TRUE(is_said(tr("tip.au_shown"), 30));
}

TEST_F(AuTips, TheWordOfARuleIsExplainedWhereItStands) {
  constexpr float kInNames = 280;
  model_.playing.aus = {{"51", "Head Left", 100, 100, ""}};
  EXPECT_FALSE(is_said(tr("tip.rule"), kInNames));
  model_.playing.aus = {{"51", "Head Left", 100, 60, "opposition: 51 100 % and 52 40 %: 51 60 %"}};
  EXPECT_TRUE(is_said(tr("tip.rule"), kInNames));
}

}  // namespace
}  // namespace aucast::gui
