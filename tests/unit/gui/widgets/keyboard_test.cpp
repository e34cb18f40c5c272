// The panels by keyboard alone: keys as ImGui has them, without a display.

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "client/gui/texts/texts.h"
#include "client/gui/widgets/keyboard_focus.h"
#include "tests/unit/gui/gui_by_hand.h"

namespace aucast::gui {
namespace {

using Keyboard = GuiByHand;

TEST_F(Keyboard, TabShowsTheFocusAndEscapeOrAClickHidesIt) {
  EXPECT_FALSE(gui_->focus_shown());
  press(ImGuiKey_Tab);
  EXPECT_TRUE(gui_->focus_shown());
  EXPECT_NE(focus(), 0U);
  EXPECT_TRUE(gui_->hide_focus());
  EXPECT_FALSE(gui_->hide_focus());
  press(ImGuiKey_Tab);
  ImGui::GetIO().MouseDown[0] = true;
  frames(2);
  ImGui::GetIO().MouseDown[0] = false;
  EXPECT_FALSE(gui_->focus_shown());
}

TEST_F(Keyboard, ShiftAndTabGoBackToWhereTabCameFrom) {
  std::vector<ImGuiID> there;
  for (int i = 0; i < 30; ++i) {
    press(ImGuiKey_Tab);
    there.push_back(focus());
  }
  for (std::size_t i = there.size() - 1; i-- > 0;) {
    press(ImGuiKey_Tab, true);
    EXPECT_EQ(focus(), there[i]) << i;
  }
}

TEST_F(Keyboard, AButtonIsPressedByEnterAndBySpace) {
  ASSERT_TRUE(go_to(tr("play.connect")));
  press(ImGuiKey_Space);
  EXPECT_TRUE(asked<Connect>());
  commands_.clear();
  press(ImGuiKey_Enter);
  EXPECT_TRUE(asked<Connect>());
}

TEST_F(Keyboard, AnExpressionIsChosenAndItsStrengthSet) {
  ASSERT_TRUE(go_to_tab("Expression"));
  bool chosen = false;
  for (int i = 0; i < 60 && !chosen; ++i) {
    press(ImGuiKey_Tab);
    press(ImGuiKey_Space);
    chosen = asked<ShowExpression>().has_value();
  }
  EXPECT_TRUE(chosen);
  if (ImGui::GetCurrentContext()->OpenPopupStack.Size > 0) press(ImGuiKey_Escape);
  ASSERT_TRUE(go_to("##strength"));
  EXPECT_EQ(ImGui::GetCurrentContext()->ActiveId, 0U) << "nothing is typed in yet";
  press(ImGuiKey_Space);
  press(ImGuiKey_LeftArrow);
  const auto strength = asked<ChangeStrength>();
  ASSERT_TRUE(strength);
  EXPECT_LT(strength->percent, 100);
}

TEST_F(Keyboard, EnterShowsTheFirstExpressionThatWasFound) {
  for (const char* const label : {"Fear", "Shame", "Sham"})
    model_.expressions.buttons.push_back({label, "24", ExpressionKind::Other});
  ASSERT_TRUE(go_to_tab("Expression"));
  ASSERT_TRUE(go_to("##more"));
  press(ImGuiKey_Enter);
  press(ImGuiKey_Enter);
  EXPECT_FALSE(asked<ShowExpression>()) << "nothing was looked for";
  type("zz");
  press(ImGuiKey_Enter);
  EXPECT_FALSE(asked<ShowExpression>()) << "it can be typed anew";
  type("sham");
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<ShowExpression>());
  EXPECT_EQ(asked<ShowExpression>()->index, 3U);
}

TEST_F(Keyboard, AFileIsFoundByItsFirstLettersAndOpened) {
  model_.browser.open = true;
  model_.browser.folder = "/streams";
  model_.browser.entries = {{"lectures", true}, {"smile.txt"}, {"talk.txt"}, {"tired.txt"}};
  frames(4);
  type("t");
  type("i");
  press(ImGuiKey_Enter);
  const auto file = asked<ChooseFile>();
  ASSERT_TRUE(file);
  EXPECT_EQ(file->file, "tired.txt");
}

TEST_F(Keyboard, AMistypedFolderIsCorrectedWhereItStands) {
  model_.browser.open = true;
  model_.browser.folder = "/streams";
  frames(4);
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  const ImGuiWindow* const dialog = context.OpenPopupStack.back().Window;
  const ImGuiID field = ImHashStr("##folder", 0, dialog->ID);
  for (int i = 0; i < 20 && context.ActiveId != field; ++i) press(ImGuiKey_Tab);
  ASSERT_EQ(context.ActiveId, field);
  type("x");
  model_.browser.problem = "there is no such folder";
  commands_.clear();
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<ChooseFile>());
  type("y");
  commands_.clear();
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<ChooseFile>());
  EXPECT_NE(asked<ChooseFile>()->file.find('y'), std::string::npos);
}

TEST_F(Keyboard, AnAuIsFoundByItsNumberAndByItsName) {
  auto aus = *model_.known_aus;
  aus.insert(aus.begin(), {{1, "Inner Brow Raiser", "", ""}, {2, "Outer Brow Raiser", "", ""}});
  model_.known_aus = std::make_shared<const std::vector<AuEntry>>(aus);
  ASSERT_TRUE(go_to_tab("Editor"));
  ASSERT_TRUE(go_to("##edit"));
  const auto chosen_by = [this](const char* first, const char* then) {
    press(ImGuiKey_Enter);
    // Nothing is drawn while nothing happens.
    ImGuiIO& io = ImGui::GetIO();
    io.AddInputCharactersUTF8(first);
    io.DeltaTime = 5;
    frames(1);
    io.DeltaTime = 1.0F / 60;
    frames(2);
    type(then);
    commands_.clear();
    press(ImGuiKey_Enter);
    const auto asked_for = asked<LoadAu>();
    return asked_for ? asked_for->number : -1;
  };
  EXPECT_EQ(chosen_by("1", "2"), 12);
  EXPECT_EQ(chosen_by("2", ""), 2);
  EXPECT_EQ(chosen_by("l", "i"), 12);
}

TEST_F(Keyboard, WhatIsTypedAsADialogOpensIsNotLost) {
  model_.browser.open = true;
  model_.browser.folder = "/streams";
  model_.browser.entries = {{"lectures", true}, {"smile.txt"}, {"talk.txt"}, {"tired.txt"}};
  type("tired");
  commands_.clear();
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<ChooseFile>());
  EXPECT_EQ(asked<ChooseFile>()->file, "tired.txt");
  model_.browser = {};
  frames(2);
  model_.browser.open = true;
  model_.browser.purpose = Purpose::SaveStream;
  model_.browser.folder = "/streams";
  model_.browser.name = "composed.txt";
  type("new.txt");
  frames(3);
  commands_.clear();
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<ChooseFile>());
  EXPECT_EQ(asked<ChooseFile>()->file, "new.txt");
}

TEST_F(Keyboard, ANewFileIsSavedByEnterAndTypingNamesItAnew) {
  model_.browser.open = true;
  model_.browser.purpose = Purpose::ExportAu;
  model_.browser.folder = "/faces";
  model_.browser.name = "au12.toml";
  frames(4);
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<ChooseFile>().has_value());
  EXPECT_EQ(asked<ChooseFile>()->file, "au12.toml");
  commands_.clear();
  model_.browser = {};
  frames(2);
  model_.browser.open = true;
  model_.browser.purpose = Purpose::ExportAu;
  model_.browser.folder = "/faces";
  model_.browser.name = "au12.toml";
  frames(4);
  type("smile.toml");
  press(ImGuiKey_Enter);
  ASSERT_TRUE(asked<ChooseFile>().has_value());
  EXPECT_EQ(asked<ChooseFile>()->file, "smile.toml");
}

TEST_F(Keyboard, ArrowsWalkThroughTheFiles) {
  model_.browser.open = true;
  model_.browser.folder = "/streams";
  model_.browser.entries = {{"smile.txt"}, {"talk.txt"}, {"tired.txt"}};
  frames(4);
  press(ImGuiKey_DownArrow);
  press(ImGuiKey_Enter);
  const auto file = asked<ChooseFile>();
  ASSERT_TRUE(file);
  EXPECT_EQ(file->file, "talk.txt");
}

TEST_F(Keyboard, AClosedNoticeStaysClosedWhileTheTimeGoesOn) {
  model_.playing.detail = "the connection was lost";
  model_.playing.tries_again = true;
  model_.playing.again_s = 5;
  frames(2);
  EXPECT_TRUE(gui_->close_notice());
  model_.playing.again_s = 4;
  frames(2);
  EXPECT_FALSE(gui_->close_notice());
}

TEST_F(Keyboard, TheChartOfTheBufferIsLargerOnAClick) {
  const auto grows = [this](float y) {
    const float before = contents()->ContentSize.y;
    point_at(720, y);
    ImGui::GetIO().MouseDown[0] = true;
    frames(2);
    ImGui::GetIO().MouseDown[0] = false;
    frames(3);
    return contents()->ContentSize.y - before;
  };
  ASSERT_TRUE(go_to_tab("Play"));
  constexpr float kMore = 160 - 34;
  float found = 0;
  for (float y = 100; y < 790 && found == 0; y += 12) {
    const float by = grows(y);
    if (by == kMore) found = y;
    if (by != 0 && by != kMore) {
      EXPECT_EQ(grows(y), -by) << "a part that was unfolded";
    }
  }
  ASSERT_GT(found, 0);
  EXPECT_EQ(grows(found), -kMore) << "and smaller again";
}

TEST_F(Keyboard, TheListOfKeysFitsIntoASmallWindow) {
  ImGui::GetIO().DisplaySize = ImVec2(800, 600);
  gui_->toggle_keys();
  frames(4);
  const ImRect list = rect_of("###keys");
  EXPECT_TRUE(ImRect(0, 0, 800, 600).Contains(list));
  EXPECT_EQ(ImGui::FindWindowByID(ImHashStr("###keys"))->ScrollMax.y, 0) << "all is seen";
}

TEST_F(Keyboard, TheListOfKeysGrowsWithItsText) {
  ImGui::GetIO().DisplaySize = ImVec2(1280, 800);
  gui_->toggle_keys();
  frames(4);
  const float before = rect_of("###keys").GetWidth();
  gui_->toggle_keys();
  frames(4);
  model_.display.settings.text_percent = 150;
  ASSERT_TRUE(gui_->prepare(model_.display));
  gui_->toggle_keys();
  frames(4);
  EXPECT_GT(rect_of("###keys").GetWidth(), 1.4F * before);
  EXPECT_EQ(ImGui::FindWindowByID(ImHashStr("###keys"))->ScrollMax.x, 0) << "no line is cut";
}

TEST_F(Keyboard, TheGalleryIsInsideTheWindow) {
  model_.gallery.open = true;
  for (const float height : {600.0F, 800.0F}) {
    ImGui::GetIO().DisplaySize = ImVec2(800, height);
    for (const int percent : {100, 200}) {
      model_.display.settings.text_percent = percent;
      static_cast<void>(gui_->prepare(model_.display));
      frames(4);
      EXPECT_TRUE(ImRect(0, 0, 800, height).Contains(rect_of("###gallery"))) << percent << " %";
    }
  }
}

TEST_F(Keyboard, NothingMovesWhenAConnectionComes) {
  frames(4);
  ASSERT_NE(contents(), nullptr);
  const float before = contents()->ContentSize.y;
  model_.playing.activity = Activity::Playing;
  model_.playing.receiver_history = {0, 1};
  model_.playing.in = model_.playing.out = "12 B";
  model_.playing.protocol = "level 2";
  model_.playing.delay = "42 ms";
  frames(4);
  EXPECT_EQ(contents()->ContentSize.y, before);
}

TEST_F(Keyboard, TheTableOfAusIsOneStepAway) {
  ImGui::GetIO().DisplaySize = ImVec2(800, 500);
  model_.playing.keyframe = "keyframe 3";
  for (int au = 1; au < 40; ++au) model_.playing.aus.push_back({std::to_string(au), "", 9, 6, ""});
  frames(4);
  ASSERT_TRUE(go_to("###jump"));
  press(ImGuiKey_Enter);
  frames(4);
  EXPECT_GT(contents()->Scroll.y, 300);
}

TEST_F(Keyboard, TheTextSizeStaysInSightWhenItChanges) {
  ImGui::GetIO().DisplaySize = ImVec2(800, 600);
  model_.display.languages = {{"en", "English"}};
  ASSERT_TRUE(go_to_tab("View"));
  contents()->Scroll.y = 0;
  frames(4);
  model_.display.settings.text_percent = 150;
  ASSERT_TRUE(gui_->prepare(model_.display));
  frames(4);
  EXPECT_GT(contents()->Scroll.y, 0);
}

TEST_F(Keyboard, RepeatIsInTheSmallestBarToo) {
  model_.display.settings.text_percent = 200;
  ASSERT_TRUE(gui_->prepare(model_.display));
  ImGui::GetIO().DisplaySize = ImVec2(800, 600);
  play_something();
  const ImGuiWindow* const bar = ImGui::FindWindowByName("transport");
  ASSERT_NE(bar, nullptr);
  const ImGuiID repeat = ImHashStr("##repeat", 0, bar->ID);
  for (int i = 0; i < 200 && focus() != repeat; ++i) press(ImGuiKey_Tab);
  ASSERT_EQ(focus(), repeat);
  press(ImGuiKey_Enter);
  EXPECT_TRUE(asked<ToggleRepeat>());
}

TEST_F(Keyboard, ANarrowBarHasAllOfAWideOneInMoreLines) {
  model_.display.settings.text_percent = 120;
  ASSERT_TRUE(gui_->prepare(model_.display));
  for (const float width : {900.0F, 800.0F, 1200.0F}) {
    ImGui::GetIO().DisplaySize = ImVec2(width, 600);
    play_something();
    const ImGuiWindow* const bar = ImGui::FindWindowByName("transport");
    ASSERT_NE(bar, nullptr);
    for (const char* label : {"##kb", "##fb", "##fo", "##ko", "##speed", tr("play.loop_a")}) {
      const ImGuiID item = ImHashStr(label, 0, bar->ID);
      for (int i = 0; i < 200 && focus() != item; ++i) press(ImGuiKey_Tab);
      EXPECT_EQ(focus(), item) << label << " at " << width;
    }
    EXPECT_LE(bar->ContentSize.x, bar->InnerRect.GetWidth()) << width;
    EXPECT_LE(bar->ContentSize.y + 2 * bar->WindowPadding.y, bar->Size.y + 1) << width;
  }
}

struct TabWidgets {
  const char* tab;
  std::vector<TextKey> labels;
};

TEST_F(Keyboard, TabReachesWhatEachTabHas) {
  const std::vector<TabWidgets> tabs = {
      {"Play", {"play.connect", "button.open_file", "play.picture", "button.export", "play.where"}},
      {"Expression", {"button.show"}},
      {"Editor", {"button.neutral", "panel.linked"}},
      {"Compose", {"button.new", "button.open_dots", "compose.add", "button.neutral"}},
      {"View", {"face.other", "view.front", "view.profile", "view.muscles"}},
      {"Camera", {"camera.start", "camera.as_mirror", "camera.landmarks"}}};
  for (const TabWidgets& tab : tabs) {
    ASSERT_TRUE(go_to_tab(tab.tab)) << tab.tab;
    std::set<ImGuiID> reached;
    const ImGuiID first = focus();
    for (int i = 0; i < 150; ++i) {
      press(ImGuiKey_Tab);
      reached.insert(focus());
      if (focus() == first) break;
    }
    EXPECT_EQ(focus(), first) << tab.tab << ": Tab comes around";
    for (const TextKey label : tab.labels) {
      EXPECT_TRUE(reached.contains(id_of(tr(label)))) << tab.tab << ": " << tr(label);
    }
    EXPECT_GT(reached.size(), tab.labels.size()) << tab.tab;
  }
}

TEST_F(Keyboard, ANumberFieldIsOneStopAndItsArrowsStepIt) {
  ASSERT_TRUE(go_to_tab("Expression"));
  ASSERT_TRUE(go_to("##frames"));
  press(ImGuiKey_UpArrow);
  auto changed = asked<ChangeTransition>();
  ASSERT_TRUE(changed);
  EXPECT_EQ(changed->settings.frames, TransitionSettings().frames + 1);
  EXPECT_EQ(focus(), id_of("##frames")) << "the arrows are the field's";
  press(ImGuiKey_Tab);
  EXPECT_EQ(focus(), id_of("##frame")) << "and not a button of the field";
  commands_.clear();
  press(ImGuiKey_DownArrow);
  changed = asked<ChangeTransition>();
  ASSERT_TRUE(changed);
  EXPECT_EQ(changed->settings.frame_ms, TransitionSettings().frame_ms - 1);
  press(ImGuiKey_Tab, true);
  EXPECT_EQ(focus(), id_of("##frames"));
}

TEST_F(Keyboard, NoButtonMovesWhenAFileIsOpened) {
  ASSERT_TRUE(go_to(tr("play.picture")));
  const auto height = [] {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    return context.NavWindow->NavRectRel[context.NavLayer].Min.y;
  };
  const float before = height();
  play_something();
  ASSERT_TRUE(go_to(tr("play.picture")));
  EXPECT_EQ(height(), before) << "a picture was saved for another button's click";
}

TEST_F(Keyboard, NothingMovesBelowWhatIsSaidOfAnAu) {
  model_.editor.groups = {{"Mouth", {{"zygomaticus major", 2, 0, 1, 0.5F, 0.5F}}}};
  auto aus = *model_.known_aus;
  aus.push_back({77, "", "zygomaticus major 1", ""});
  aus.push_back({26, "Jaw Drop", std::string(900, 'm') + " 1", std::string(300, 'x')});
  model_.known_aus = std::make_shared<const std::vector<AuEntry>>(aus);
  ASSERT_TRUE(go_to_tab("Editor"));
  gui_->hide_focus();
  std::set<float> heights;
  for (const int au : {12, 77, 26, -1}) {
    model_.editor.au = au;
    model_.notice = {au == 12 ? "AU12 saved" : "", false};
    frames(4);
    ASSERT_NE(contents(), nullptr);
    heights.insert(contents()->ContentSize.y);
  }
  EXPECT_EQ(heights.size(), 1U);
}

TEST_F(Keyboard, AnAuThatFacsDoesNotNameIsAskedForOne) {
  model_.known_aus =
      std::make_shared<const std::vector<AuEntry>>(std::vector<AuEntry>{{90, "", "jaw 1", ""}});
  model_.editor.au = 90;
  ASSERT_TRUE(go_to_tab("Editor"));
  ASSERT_TRUE(go_to(tr("button.save")));
  press(ImGuiKey_Enter);
  frames(3);
  EXPECT_EQ(focus(), id_of("##auname"));
  commands_.clear();
  type("yawn");
  const auto named = asked<NameAu>();
  ASSERT_TRUE(named) << "or it could be lost without a question";
  EXPECT_EQ(named->number, 90);
  commands_.clear();
  press(ImGuiKey_Enter);
  auto saved = asked<SaveAu>();
  ASSERT_TRUE(saved) << "Enter in the field saves";
  EXPECT_EQ(saved->name, "yawn");
  ASSERT_TRUE(go_to(tr("button.save")));
  commands_.clear();
  press(ImGuiKey_Enter);
  saved = asked<SaveAu>();
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->name, "yawn");
}

TEST_F(Keyboard, AButtonIsAsWideAsItsText) {
  ASSERT_TRUE(go_to_tab("Compose"));
  model_.composer.rows =
      std::make_shared<const std::vector<TimelineRow>>(std::vector<TimelineRow>{{"12", "1 s"}});
  model_.composer.chosen = 0;
  ASSERT_TRUE(go_to(tr("compose.double")));
  const ImRect button = contents()->NavRectRel[0];
  EXPECT_GE(button.GetWidth(),
            ImGui::CalcTextSize(tr("compose.double")).x + ImGui::GetStyle().FramePadding.x - 0.5F);
}

TEST_F(Keyboard, WhatIsSaidOfTheConnectionIsClosedAndStaysClosed) {
  const auto said = [] {
    const ImGuiWindow* const window = ImGui::FindWindowByName("trouble");
    return window != nullptr && window->Active;
  };
  EXPECT_FALSE(gui_->close_notice());
  model_.playing.detail = "venus cannot be reached";
  frames(2);
  EXPECT_TRUE(said());
  EXPECT_TRUE(gui_->close_notice());
  EXPECT_FALSE(gui_->close_notice()) << "Esc is for the next thing";
  frames(2);
  EXPECT_FALSE(said());
  model_.playing.detail.clear();
  model_.playing.ended_by = "venus";
  frames(2);
  EXPECT_TRUE(said());
  EXPECT_TRUE(gui_->close_notice());
}

TEST_F(Keyboard, NoFileMovesWhenOneIsChosenThatIsReadInAWayOfItsOwn) {
  const auto height_of_list = [this] {
    model_.browser.open = true;
    model_.browser.folder = "/streams";
    frames(4);
    float height = 0;
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
      const bool list = std::string(window->Name).find("/entries_") != std::string::npos;
      if (list && window->WasActive) height = window->Size.y;
    }
    model_.browser.open = false;
    frames(4);
    return height;
  };
  const float usual = height_of_list();
  model_.tables.asked = TableSettings{.gain_percent = 150};
  EXPECT_EQ(height_of_list(), usual);
}

TEST_F(Keyboard, TheGainIsSteppedFromAHundredPercent) {
  model_.browser.open = true;
  model_.browser.folder = "/streams";
  frames(4);
  const auto go_on_to = [this](const char* label) {
    for (int i = 0; i < 30; ++i) {
      ImGuiWindow* const window = ImGui::GetCurrentContext()->NavWindow;
      if (window != nullptr && focus() == window->GetID(label)) return true;
      press(ImGuiKey_Tab);
    }
    return false;
  };
  ASSERT_TRUE(go_on_to(tr("file.tables")));
  press(ImGuiKey_Enter);
  ASSERT_TRUE(go_on_to("##gain"));
  press(ImGuiKey_UpArrow);
  auto changed = asked<ChangeTable>();
  ASSERT_TRUE(changed);
  EXPECT_EQ(changed->settings.gain_percent, 100);
  model_.tables.asked = changed->settings;
  commands_.clear();
  frames(2);
  press(ImGuiKey_UpArrow);
  changed = asked<ChangeTable>();
  ASSERT_TRUE(changed);
  EXPECT_EQ(changed->settings.gain_percent, 110);
}

TEST_F(Keyboard, AVideoIsEndedFromEveryTab) {
  model_.video.recording = "/tmp/a.mp4";
  ASSERT_TRUE(go_to_tab(tr("tab.view")));
  ImGuiWindow* const panel = ImGui::FindWindowByName("panel");
  ASSERT_NE(panel, nullptr);
  for (int i = 0; i < 60 && focus() != panel->GetID("##recording"); ++i) press(ImGuiKey_Tab);
  ASSERT_EQ(focus(), panel->GetID("##recording"));
  press(ImGuiKey_Enter);
  EXPECT_TRUE(asked<ToggleVideo>());
}

TEST_F(Keyboard, TheFocusGoesOnToWhatLiesOverTheFace) {
  const ImGuiWindow* const welcome = ImGui::FindWindowByName("welcome");
  ASSERT_NE(welcome, nullptr);
  bool seen = false;
  for (int i = 0; i < 100 && !seen; ++i) {
    press(ImGuiKey_Tab);
    seen = ImGui::GetCurrentContext()->NavWindow == welcome;
  }
  EXPECT_TRUE(seen);
  press(ImGuiKey_Tab, true);
  EXPECT_NE(ImGui::GetCurrentContext()->NavWindow, welcome);
}

TEST_F(Keyboard, AFileThatPlaysIsPausedAndStoppedBesideConnectToo) {
  play_something();
  model_.playing.local = true;
  model_.playing.activity = Activity::Playing;
  ASSERT_TRUE(go_to(tr("play.pause")));
  press(ImGuiKey_Enter);
  EXPECT_TRUE(asked<Pause>());
  ASSERT_TRUE(go_to(tr("play.stop")));
  press(ImGuiKey_Enter);
  EXPECT_TRUE(asked<Stop>());
  EXPECT_FALSE(asked<Seek>()) << "which would show the stream in place of what is edited";
  model_.playing.activity = Activity::Paused;
  frames(2);
  ASSERT_TRUE(go_to(tr("play.resume")));
  press(ImGuiKey_Enter);
  EXPECT_TRUE(asked<Resume>());
  const auto asks_to_stop = [this] {
    commands_.clear();
    if (go_to(tr("play.stop"))) press(ImGuiKey_Enter);
    return asked<Stop>().has_value();
  };
  EXPECT_FALSE(asks_to_stop()) << "it stands at its beginning";
  model_.local.position = Milliseconds(100);
  frames(2);
  EXPECT_TRUE(asks_to_stop());
}

}  // namespace
}  // namespace aucast::gui
