// The widgets alone, in a window of the test's own.
#include "client/gui/widgets/widgets.h"

#include <functional>
#include <memory>
#include <string>

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "client/gui/gui.h"
#include "client/gui/widgets/fields.h"
#include "client/gui/widgets/tips.h"
#include "tests/unit/gui/gui_by_hand.h"

namespace aucast::gui {
namespace {

/// Draws what a test says, 400 wide, with font and style of the panels.
class Widgets : public testing::Test {
 protected:
  void SetUp() override {
    use_by_hand(ImVec2(1000, 600));
    ImGui::GetIO().MousePos = ImVec2(900, 500);
  }

  /// From now on; `what` is called once a frame.
  void draw(std::function<void()> what) {
    what_ = std::move(what);
    frame();
    frame();
  }
  void frame() {
    ImGui::NewFrame();
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(ImVec2(400, 600));
    ImGui::Begin("test", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings);
    what_();
    ImGui::End();
    ImGui::Render();
  }
  /// The rectangle of the item that was just drawn; for use inside of draw().
  void note() { item_ = ImRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax()); }
  void point_at(float x, float y) {
    ImGui::GetIO().MousePos = ImVec2(x, y);
    frame();
    frame();
  }
  void click(float x, float y) {
    point_at(x, y);
    ImGui::GetIO().MouseDown[0] = true;
    frame();
    ImGui::GetIO().MouseDown[0] = false;
    frame();
  }
  void type(const char* text) {
    ImGui::GetIO().AddInputCharactersUTF8(text);
    frame();
    frame();
  }
  void press(ImGuiKey key) {
    ImGui::GetIO().KeysDown[key] = true;
    frame();
    ImGui::GetIO().KeysDown[key] = false;
    frame();
  }
  static bool tip_is_shown() {
    const ImGuiWindow* const window = ImGui::FindWindowByName("##Tooltip_00");
    return window != nullptr && window->Active && !window->Hidden;
  }

  Gui gui_{1.0F};
  Look look_{1, ImGui::GetIO().Fonts->Fonts[0]};
  ImRect item_;
  std::function<void()> what_;
};

/// A field of a number in 0 to 100, as wide as the window.
class NumberField : public Widgets {
 protected:
  void draw_field(float width = -1) {
    draw([this, width] {
      ImGui::SetNextItemWidth(width);
      changes_ += number_field("##number", value_, steps_, when_entered_) ? 1 : 0;
      note();
    });
  }
  /// -1 or 1.
  void click_button(int direction) {
    const float size = ImGui::GetFrameHeight();
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float plus = item_.Max.x - size / 2;
    click(direction > 0 ? plus : plus - size - gap, item_.GetCenter().y);
  }
  void click_text() { click(item_.Min.x + 20, item_.GetCenter().y); }

  Steps steps_{.near = 1, .far = 10, .least = 0, .most = 100};
  int value_ = 50;
  int changes_ = 0;
  bool when_entered_ = false;
};

TEST_F(NumberField, ItsButtonsStepAndWithCtrlStepFar) {
  draw_field();
  click_button(1);
  EXPECT_EQ(value_, 51);
  click_button(-1);
  click_button(-1);
  EXPECT_EQ(value_, 49);
  EXPECT_EQ(changes_, 3);
  ImGui::GetIO().KeyCtrl = true;
  click_button(1);
  EXPECT_EQ(value_, 59);
}

TEST_F(NumberField, StepsEndAtTheLimits) {
  value_ = 100;
  draw_field();
  click_button(1);
  EXPECT_EQ(value_, 100);
  EXPECT_EQ(changes_, 0) << "nothing has changed";
}

TEST_F(NumberField, WhatIsTypedBeyondTheLimitsIsCutAndThatIsSaid) {
  draw_field();
  click_text();
  type("70");
  EXPECT_EQ(value_, 70);
  EXPECT_FALSE(tip_is_shown());
  type("0");
  EXPECT_EQ(value_, 100);
  EXPECT_TRUE(tip_is_shown());
}

TEST_F(NumberField, TypingCountsAtEnterWhereThatIsAskedFor) {
  when_entered_ = true;
  draw_field();
  click_text();
  type("70");
  EXPECT_EQ(value_, 50);
  press(ImGuiKey_Enter);
  EXPECT_EQ(value_, 70);
}

TEST_F(NumberField, UpAndDownStepWhatIsTyped) {
  draw_field();
  click_text();
  press(ImGuiKey_UpArrow);
  EXPECT_EQ(value_, 51);
  press(ImGuiKey_DownArrow);
  press(ImGuiKey_DownArrow);
  EXPECT_EQ(value_, 49);
}

TEST_F(NumberField, EmptiedIsWhatZeroMeans) {
  steps_.zero = "automatic";
  draw_field();
  click_text();
  press(ImGuiKey_Backspace);
  EXPECT_EQ(value_, 0);
}

TEST_F(NumberField, EmptiedKeepsTheNumberWhereZeroMeansNothingElse) {
  draw_field();
  click_text();
  press(ImGuiKey_Backspace);
  EXPECT_EQ(value_, 50);
}

TEST_F(NumberField, HasNoButtonsWhereTheNumberHasNoRoomBesideThem) {
  draw_field(60);
  click(item_.Max.x - 5, item_.GetCenter().y);
  EXPECT_EQ(value_, 50);
}

TEST_F(Widgets, ANumberFieldOfItsLeastWidthHasItsButtons) {
  int value = 5;
  for (const float less : {0.0F, 2.0F}) {
    value = 5;
    draw([&] {
      ImGui::SetNextItemWidth(number_field_width() - less);
      static_cast<void>(number_field("##number", value, {}));
      note();
    });
    click(item_.Max.x - 4, item_.GetCenter().y);
    EXPECT_EQ(value, less > 0 ? 5 : 6);
  }
}

TEST_F(Widgets, ASliderAndItsNumberAreAsWideAsAsked) {
  int value = 50;
  draw([&] {
    static_cast<void>(percent_slider("##share", 200, value));
    note();
  });
  EXPECT_LT(item_.GetWidth(), 200) << "the number stands beside";
  EXPECT_GT(item_.GetWidth(), 100);
  click(item_.Max.x - 1, item_.GetCenter().y);
  EXPECT_EQ(value, 100);
  click(item_.Min.x + 1, item_.GetCenter().y);
  EXPECT_EQ(value, 0);
}

TEST_F(Widgets, SlidersOfOneColumnEndTogether) {
  int small = 5;
  int large = 5000;
  float small_end = 0;
  float large_end = 0;
  draw([&] {
    static_cast<void>(slider("##small", 200, small, 0, 9, "%d", "9999"));
    small_end = ImGui::GetItemRectMax().x;
    static_cast<void>(slider("##large", 200, large, 0, 9999, "%d", "9999"));
    large_end = ImGui::GetItemRectMax().x;
  });
  EXPECT_EQ(small_end, large_end);
}

TEST_F(Widgets, WideButtonsShareALineAndALongOneTakesTheNext) {
  ImRect first;
  const auto draw_two = [&](const char* second) {
    draw([&, second] {
      static_cast<void>(wide_button("Stop", 0, 2, true));
      first = ImRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
      static_cast<void>(wide_button(second, 1, 2, true));
      note();
    });
  };
  draw_two("Go");
  EXPECT_EQ(item_.Min.y, first.Min.y);
  EXPECT_FLOAT_EQ(item_.GetWidth(), first.GetWidth());
  EXPECT_GT(item_.Min.x, first.Max.x);
  draw_two("A button that has much more to say than its share of the line has room for");
  EXPECT_GT(item_.Min.y, first.Min.y);
  EXPECT_LE(item_.Max.x, 400);
  EXPECT_GT(item_.GetHeight(), first.GetHeight()) << "in several lines";
}

TEST_F(Widgets, ADisabledWideButtonIsNotPressed) {
  bool enabled = false;
  int pressed = 0;
  draw([&] {
    pressed += wide_button("Go", 0, 1, enabled, true) ? 1 : 0;
    note();
  });
  click(item_.GetCenter().x, item_.GetCenter().y);
  EXPECT_EQ(pressed, 0);
  enabled = true;
  click(item_.GetCenter().x, item_.GetCenter().y);
  EXPECT_EQ(pressed, 1);
}

TEST_F(Widgets, AChoiceChangesOnlyToAnotherWord) {
  const std::array<Word, 2> words = {{{"one"}, {"two"}}};
  int chosen = 0;
  int changes = 0;
  draw([&] {
    changes += choice("##words", words, chosen) ? 1 : 0;
    note();
  });
  click(item_.GetCenter().x, item_.GetCenter().y);
  EXPECT_EQ(chosen, 1);
  click(item_.GetCenter().x, item_.GetCenter().y);
  EXPECT_EQ(changes, 1);
}

TEST_F(Widgets, AFittedTextEndsWhereItIsTold) {
  const std::string text = "A text that is much longer than a hundred pixels";
  draw([&] {
    fitted_text(text, 100);
    note();
  });
  EXPECT_LE(item_.Max.x, 100);
  draw([&] {
    fitted_text("short", 300);
    note();
  });
  EXPECT_LT(item_.Max.x, 100) << "no wider than it is";
}

TEST_F(Widgets, AQuietTextBreaksAtSpacesAlone) {
  ImVec2 one_line;
  draw([&] {
    quiet_text("0.7");
    one_line = ImGui::GetItemRectSize();
  });
  ImVec2 narrow;
  draw([&] {
    ImGui::BeginChild("narrow", ImVec2(one_line.x * 2.5F, 200));
    quiet_text("at 0.7");
    narrow = ImGui::GetItemRectSize();
    ImGui::EndChild();
  });
  EXPECT_FLOAT_EQ(narrow.y, one_line.y);
  draw([&] {
    ImGui::BeginChild("narrow", ImVec2(one_line.x + 2, 200));
    quiet_text("at 0.7");
    narrow = ImGui::GetItemRectSize();
    ImGui::EndChild();
  });
  EXPECT_GT(narrow.y, one_line.y);
  EXPECT_LE(narrow.x, one_line.x + 2);
}

TEST_F(Widgets, ATipIsGoneOnceWhatItTellsOfIsUsed) {
  draw([&] {
    ImGui::Button("Go");
    tip("Goes.");
    note();
  });
  EXPECT_FALSE(tip_is_shown());
  point_at(item_.GetCenter().x, item_.GetCenter().y);
  EXPECT_TRUE(tip_is_shown());
  click(item_.GetCenter().x, item_.GetCenter().y);
  EXPECT_FALSE(tip_is_shown());
  point_at(900, 500);
  point_at(item_.GetCenter().x, item_.GetCenter().y);
  EXPECT_TRUE(tip_is_shown()) << "told anew";
}

TEST_F(Widgets, ADisabledItemHasATipOnlyWhereThatIsAskedFor) {
  bool also_disabled = false;
  draw([&] {
    ImGui::BeginDisabled();
    ImGui::Button("Go");
    ImGui::EndDisabled();
    tip("Not yet.", also_disabled);
    note();
  });
  point_at(item_.GetCenter().x, item_.GetCenter().y);
  EXPECT_FALSE(tip_is_shown());
  also_disabled = true;
  frame();
  frame();
  EXPECT_TRUE(tip_is_shown());
}

TEST_F(Widgets, AWidgetKeepsItsIdInEveryLanguage) {
  ImGuiID english = 0;
  ImGuiID french = 0;
  draw([&] {
    english = ImGui::GetID(with_id("Leave", "leave").c_str());
    french = ImGui::GetID(with_id("Quitter", "leave").c_str());
  });
  EXPECT_EQ(english, french);
}

TEST_F(Widgets, AControlWithoutRoomBesideItsLabelStandsBelowIt) {
  // `scale` moves the column of the values, in a window that stays 400 wide.
  const auto below = [this](float scale) {
    float label_end = 0;
    draw([&] {
      label(Look{.scale = scale}, "Stream", "");
      label_end = ImGui::GetItemRectMax().y;
      ImGui::Button("x", ImVec2(-1, 0));
      note();
    });
    return item_.Min.y >= label_end;
  };
  EXPECT_FALSE(below(1));
  EXPECT_TRUE(below(3));
  EXPECT_GT(item_.GetWidth(), 350) << "it has the whole line";
}

TEST_F(Widgets, RoomBesideIsMeasuredUpToTheMargin) {
  bool small = false;
  bool large = true;
  draw([&] {
    ImGui::Button("Go", ImVec2(100, 0));
    small = has_room_beside(200);
    large = has_room_beside(300);
  });
  EXPECT_TRUE(small);
  EXPECT_FALSE(large);
}

}  // namespace
}  // namespace aucast::gui
