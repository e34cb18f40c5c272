#include <epoxy/gl.h>

#include <backends/imgui_impl_opengl3.h>
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <array>
#include <cstdint>
#include <memory>
#include <set>
#include <utility>
#include <variant>

#include "client/gui/gui.h"
#include "client/render/offscreen_context.h"
#include "client/render/offscreen_target.h"
#include "client/view/image.h"

namespace aucast::gui {
namespace {

constexpr int kWidth = 800;
constexpr int kHeight = 720;

GuiModel playing_model() {
  GuiModel model;
  model.playing.activity = Activity::Playing;
  model.playing.state = "playing";
  model.playing.keyframe = "keyframe 3";
  model.playing.receiver = {42, 100, 40};
  model.playing.playout = {12, 30, 0};
  model.playing.receiver_history = {0, 0.2F, 0.42F};
  model.playing.in = "6 packets, 93 B";
  model.playing.out = "12 B";
  model.playing.protocol = "level 2";
  model.playing.au_history = {{12, {0, 0.5F, 1}}, {51, {1, 0.5F, 0.6F}}};
  model.recent = {"lecture.example.org", "10.0.0.7:4651"};
  model.playing.aus = {{"51", "Head Turn Left", 100, 60, "opposition"}};
  model.editor.groups = {{"Mouth", {{"zygomaticus major", 2, 0, 1, 0.5F, 0.5F}}}};
  model.known_aus = std::make_shared<const std::vector<AuEntry>>(
      std::vector<AuEntry>{{12, "Lip Corner Puller", "zygomaticus major 1", "A smile."}});
  model.expressions.buttons = {{"Happiness", "6,12"}, {"Anger", "4,5,7,23"}};
  return model;
}

LocalView three_keyframes() {
  LocalView local;
  local.open = true;
  local.name = "three.txt";
  local.total = Milliseconds(600);
  local.ends = std::make_shared<const std::vector<Duration>>(
      std::vector<Duration>{Milliseconds(100), Milliseconds(300), Milliseconds(600)});
  return local;
}

/// The first command of this kind.
template <typename Command>
std::optional<Command> first_of(const GuiCommands& commands) {
  for (const GuiCommand& command : commands) {
    if (const auto* found = command_if<Command>(command)) return *found;
  }
  return std::nullopt;
}

/// Draws the panels without a window and moves a mouse over them.
class Panels : public testing::Test {
 protected:
  void SetUp() override {
    auto context = render::OffscreenContext::create();
    ASSERT_TRUE(context) << context.error().message;
    context_ = std::move(*context);
    start();
  }
  void TearDown() override { end(); }

  void start() {
    auto target = render::OffscreenTarget::create(kWidth, kHeight);
    ASSERT_TRUE(target) << target.error().message;
    target_ = std::move(*target);
    gui_ = std::make_unique<Gui>(1.0F);
    ASSERT_TRUE(ImGui_ImplOpenGL3_Init("#version 330 core"));
  }
  void end() {
    if (gui_) ImGui_ImplOpenGL3_Shutdown();
    gui_.reset();
    target_.reset();
  }

  /// Pixels are only made for pictures: software OpenGL takes most of the time.
  GuiCommands frame(bool pixels = false) {
    if (pixels) {
      target_->bind();
      glViewport(0, 0, kWidth, kHeight);
      glClearColor(0, 0, 0, 1);
      glClear(GL_COLOR_BUFFER_BIT);
    }
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(kWidth, kHeight);
    io.DeltaTime = 1.0F / 60;
    ImGui_ImplOpenGL3_NewFrame();
    GuiCommands commands;
    gui_->draw(model_, commands);
    if (pixels) ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    return commands;
  }
  view::Image picture() {
    for (int i = 0; i < 2; ++i) static_cast<void>(frame());
    static_cast<void>(frame(true));
    return target_->read();
  }
  /// Presses and releases the left button there; everything that was asked for meanwhile.
  GuiCommands click(float x, float y) {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = ImVec2(x, y);
    GuiCommands all;
    for (const bool down : {false, false, true, true, false, false}) {
      io.MouseDown[0] = down;
      for (GuiCommand& command : frame()) all.push_back(std::move(command));
    }
    return all;
  }
  /// Clicks down a column of the panel until something is asked for.
  template <typename Command>
  std::optional<Command> find_by_clicking(float x, float from_y, float to_y) {
    for (float y = from_y; y < to_y; y += 12) {
      for (const GuiCommand& command : click(x, y)) {
        if (const auto* found = command_if<Command>(command)) return *found;
      }
    }
    return std::nullopt;
  }

  GuiModel model_ = playing_model();
  std::unique_ptr<render::OffscreenContext> context_;
  std::unique_ptr<render::OffscreenTarget> target_;
  std::unique_ptr<Gui> gui_;
};

std::size_t bright_pixels(const view::Image& picture, int from_x, int to_x) {
  std::size_t count = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = from_x; x < to_x; ++x) {
      const auto at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                           static_cast<std::size_t>(x));
      count += picture.rgba[at] > 150 ? 1U : 0U;
    }
  }
  return count;
}

/// A part of a picture, as wide as it is.
view::Image rows(const view::Image& picture, int from, int to) {
  view::Image part = view::make_image(picture.width, to - from);
  view::paste(part, picture, 0, -from);
  return part;
}

TEST_F(Panels, TheSameModelGivesTheSamePicture) {
  const view::Image first = picture();
  end();
  start();
  const view::Image second = picture();
  EXPECT_EQ(first.rgba, second.rgba);
}

TEST_F(Panels, ThePanelLeavesTheFaceFreeAndCanBeHidden) {
  const view::Image shown = picture();
  const int edge = kWidth - static_cast<int>(gui_->covered_width());
  EXPECT_GT(edge, kWidth / 2 - 1);
  EXPECT_EQ(bright_pixels(shown, 0, edge), 0U);
  EXPECT_GT(bright_pixels(shown, edge, kWidth), 2000U);
  gui_->toggle_panel();
  EXPECT_EQ(gui_->covered_width(), 0);
  EXPECT_EQ(bright_pixels(picture(), 0, kWidth), 0U);
}

TEST_F(Panels, WhatAHiddenPanelTookIsTheFaces) {
  EXPECT_GT(bright_pixels(picture(), 0, kWidth), 2000U);
  const float taken = gui_->covered_width();
  gui_->set_hidden(true);  // as in full screen, while the mouse is still
  EXPECT_EQ(gui_->covered_width(), 0);
  EXPECT_EQ(bright_pixels(picture(), 0, kWidth), 0U);
  gui_->set_hidden(false);
  EXPECT_EQ(gui_->covered_width(), taken);
  EXPECT_GT(bright_pixels(picture(), 0, kWidth), 2000U);
}

TEST_F(Panels, ACaptionIsWholeInItsFirstPicture) {
  model_.spoken.shown = true;
  model_.spoken.caption = "Yes.";
  static_cast<void>(picture());
  model_.spoken.caption = "It is a face, sent as a short list of movements, which come as text.";
  static_cast<void>(frame(true));
  const view::Image first = target_->read();
  EXPECT_EQ(first.rgba, picture().rgba);
}

TEST_F(Panels, TheFaceAloneIsWithoutPanelAndBar) {
  model_.local = three_keyframes();
  gui_->toggle_bare();
  EXPECT_EQ(gui_->covered_width(), 0);
  EXPECT_EQ(bright_pixels(picture(), 0, kWidth), 0U);
  EXPECT_TRUE(gui_->end_bare());
  EXPECT_GT(gui_->covered_width(), 0);
  EXPECT_FALSE(gui_->end_bare()) << "it was not alone any more";
  gui_->toggle_bare();
  gui_->toggle_panel();
  EXPECT_GT(gui_->covered_width(), 0) << "the panel is asked for";
}

TEST_F(Panels, EscapeClosesADropDown) {
  static_cast<void>(click(767, 123));  // the last addresses
  EXPECT_TRUE(gui_->wants_keys());
  ImGuiIO& io = ImGui::GetIO();
  io.KeyMap[ImGuiKey_Escape] = 1;
  io.KeysDown[1] = true;
  static_cast<void>(frame());
  io.KeysDown[1] = false;
  static_cast<void>(frame());
  EXPECT_FALSE(gui_->wants_keys());
}

TEST_F(Panels, WhatPlaysCanBePausedAndStopped) {
  EXPECT_TRUE(find_by_clicking<Pause>(590, 100, 260).has_value());
  EXPECT_TRUE(find_by_clicking<Stop>(700, 100, 260).has_value());
  model_.playing.activity = Activity::Paused;
  EXPECT_TRUE(find_by_clicking<Resume>(590, 100, 260).has_value());
}

TEST_F(Panels, ConnectTakesTheForm) {
  model_.playing.activity = Activity::Idle;
  model_.remote_settings.address = "lecture.example.org";
  model_.remote_settings.port = 4777;
  const auto connect = find_by_clicking<Connect>(480, 100, 260);
  ASSERT_TRUE(connect.has_value());
  EXPECT_EQ(connect->settings, model_.remote_settings);
}

TEST_F(Panels, AMistypedServerIsCorrectedWhileItIsStillTried) {
  model_.playing.activity = Activity::Connecting;
  EXPECT_FALSE(find_by_clicking<Connect>(480, 100, 260).has_value()) << "it is being tried";
  model_.remote_settings.port = 1;
  const auto connect = find_by_clicking<Connect>(480, 100, 260);
  ASSERT_TRUE(connect.has_value()) << "the form says another port than is tried";
  EXPECT_NE(connect->settings.port, 1);
}

TEST_F(Panels, WhoWaitsForALostServerMayTryItAtOnce) {
  model_.playing.activity = Activity::Connecting;
  model_.playing.detail = "the connection was lost";
  EXPECT_TRUE(find_by_clicking<Connect>(480, 100, 260).has_value());
}

TEST_F(Panels, EnterInTheAddressConnects) {
  model_.playing.activity = Activity::Idle;
  model_.remote_settings.address = "a";
  static_cast<void>(click(700, 123));
  ImGui::GetIO().AddInputCharactersUTF8("b.example:4777/talk");
  static_cast<void>(frame());
  ImGuiIO& io = ImGui::GetIO();
  io.KeyMap[ImGuiKey_Enter] = 1;
  io.KeysDown[1] = true;
  const auto connect = first_of<Connect>(frame());
  ASSERT_TRUE(connect.has_value());
  EXPECT_EQ(connect->settings.address, "b.example") << "a click chooses what is there";
  EXPECT_EQ(connect->settings.port, 4777);
  EXPECT_EQ(connect->settings.stream, "talk");
}

TEST_F(Panels, AStreamOfTheServerIsChosenFromTheList) {
  const GuiCommands opened = click(700, 154);
  ASSERT_TRUE(first_of<AskStreams>(opened).has_value());
  model_.streams.streams = {{"talk"}, {"lecture"}};
  const auto connect = find_by_clicking<Connect>(600, 170, 200);
  ASSERT_TRUE(connect.has_value());
  EXPECT_EQ(connect->settings.stream, "talk");
}

TEST_F(Panels, TheListSaysOfEachStreamWhatIsKnown) {
  model_.streams.streams = {{"talk"}, {"lecture"}};
  static_cast<void>(click(700, 154));
  const auto names = picture().rgba;
  model_.streams.streams[0].duration_ms = 83'000;
  const auto lengths = picture().rgba;
  EXPECT_NE(lengths, names);
  model_.streams.streams[1].title = "Faces that speak";
  const auto titles = picture().rgba;
  EXPECT_NE(titles, lengths);
  model_.streams.streams[0].live = true;
  EXPECT_NE(picture().rgba, titles) << "it is live, however long";
}

TEST_F(Panels, TheLongestTitleKeepsTheListInTheWindow) {
  model_.streams.streams = {{"talk", false, 83'000, std::string(120, 'W')}, {"lecture"}};
  static_cast<void>(click(700, 154));
  static_cast<void>(picture());
  const ImGuiWindow* const list = ImGui::FindWindowByName("##Combo_00");
  ASSERT_NE(list, nullptr);
  EXPECT_GE(list->Pos.x, 0);
  EXPECT_LE(list->Pos.x + list->Size.x, kWidth);
  const auto connect = find_by_clicking<Connect>(list->Pos.x + list->Size.x - 20, 170, 200);
  ASSERT_TRUE(connect.has_value()) << "all of the line is for the mouse";
  EXPECT_EQ(connect->settings.stream, "talk");
}

TEST_F(Panels, TheStreamThatTheServerChoseIsNamed) {
  const auto stream = [this] {
    ImGui::GetIO().MousePos = ImVec2(1, 1);
    static_cast<void>(frame());
    return rows(picture(), 140, 168).rgba;
  };
  const auto unknown = stream();
  model_.playing.stream = "lecture";
  EXPECT_NE(stream(), unknown);
  model_.remote_settings.address = "another.example";
  EXPECT_EQ(stream(), unknown) << "not of a server that is not connected to";
}

TEST_F(Panels, TheAddressStaysAsShortAsItIsWhenAStreamIsChosen) {
  const auto address = [this] {
    ImGui::GetIO().MousePos = ImVec2(1, 1);
    return rows(picture(), 110, 136).rgba;
  };
  model_.streams.streams = {{"talk"}, {"lecture"}};
  const auto before = address();
  static_cast<void>(click(700, 154));
  ASSERT_TRUE(find_by_clicking<Connect>(600, 170, 200).has_value());
  EXPECT_EQ(address(), before) << "the stream has a field of its own";
}

TEST_F(Panels, AtFirstASampleIsOneClickAway) {
  model_.playing = {};
  model_.sample = "/streams/sample.txt";
  const auto played = find_by_clicking<OpenStream>(150, 600, 710);
  ASSERT_TRUE(played.has_value());
  EXPECT_EQ(played->file, "/streams/sample.txt");
  const view::Image offered = picture();
  model_.playing.activity = Activity::Connecting;
  EXPECT_NE(picture().rgba, offered.rgba) << "not when something was opened";
}

TEST_F(Panels, AnEmptyViewIsMadeUsualAgain) {
  model_.rendering.settings.layers.textured = false;
  model_.rendering.settings.light_percent = 10;
  model_.rendering.settings.blinking = true;
  static_cast<void>(click(693, 54));  // the tab
  const auto change = find_by_clicking<ChangeRendering>(600, 532, 572);
  ASSERT_TRUE(change.has_value());
  RenderingSettings usual;
  usual.blinking = true;
  EXPECT_EQ(change->settings, usual);
}

TEST_F(Panels, AFormThatIsWrongConnectsNowhere) {
  model_.playing.activity = Activity::Idle;
  model_.remote_settings.address.clear();
  EXPECT_FALSE(find_by_clicking<Connect>(480, 100, 260).has_value());
}

TEST_F(Panels, TheMixerIsChanged) {
  const auto change = find_by_clicking<ChangeAnimation>(720, 530, kHeight);
  ASSERT_TRUE(change.has_value());
  EXPECT_EQ(change->settings.mixer, face::Mixer::Average);
}

TEST_F(Panels, WhatIsChosenLooksSoUnderThePointerToo) {
  // The row of the mixer, whose first button is chosen, is where the second one is found.
  float y = 530;
  const auto is_row = [&] {
    for (const GuiCommand& command : click(720, y)) {
      if (command_if<ChangeAnimation>(command) != nullptr) return true;
    }
    return false;
  };
  while (y < kHeight && !is_row()) y += 4;
  ASSERT_LT(y, kHeight);
  y += 4;
  // Where the row has the colour of what is chosen, with the pointer at x: how much, and the
  // middle.
  const auto marked = [&](float x) {
    ImGui::GetIO().MousePos = ImVec2(x, y);
    const view::Image drawn = picture();
    int count = 0;
    int sum = 0;
    for (int at = 440; at < kWidth; ++at) {
      const auto pixel = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(kWidth) +
                              static_cast<std::size_t>(at));
      if (drawn.rgba[pixel + 2] < drawn.rgba[pixel] + 35) continue;
      ++count;
      sum += at;
    }
    return std::pair(count,
                     count == 0 ? 0.0F : static_cast<float>(sum) / static_cast<float>(count));
  };
  const auto [away, middle] = marked(1);
  ASSERT_GT(away, 30);
  EXPECT_GE(marked(middle).first, away) << "marked under the pointer too";
}

TEST_F(Panels, NothingIsAskedForByLooking) {
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(frame().empty());
}

TEST_F(Panels, ExpressionsAreButtonsOfTheirTab) {
  static_cast<void>(click(516, 54));  // the tab
  const auto show = find_by_clicking<ShowExpression>(450, 80, 200);
  ASSERT_TRUE(show.has_value());
  EXPECT_EQ(show->index, 0U);
}

TEST_F(Panels, TheAusOfTheChosenExpressionCanBeChanged) {
  static_cast<void>(click(516, 54));  // the tab
  model_.expressions.chosen = 0;
  model_.expressions.aus = "6:40,12:40";
  const auto show = find_by_clicking<ShowAus>(760, 300, 500);
  ASSERT_TRUE(show.has_value());
  EXPECT_EQ(show->aus, "6:40,12:40");
}

TEST_F(Panels, AnExpressionOfMusclesLeavesNoAusBehind) {
  model_.expressions.buttons.push_back({"Fear", "0", ExpressionKind::Macro});
  static_cast<void>(click(516, 54));  // the tab
  model_.expressions.chosen = 0;
  model_.expressions.aus = "6:40,12:40";
  static_cast<void>(picture());
  model_.expressions.chosen = 2;
  model_.expressions.aus.clear();
  static_cast<void>(picture());
  EXPECT_FALSE(find_by_clicking<ShowAus>(760, 300, 560).has_value());
}

TEST_F(Panels, TheGripOfASliderIsNeverOnItsNumber) {
  static_cast<void>(click(516, 54));  // the tab
  for (const int percent : {0, 40, 50, 100}) {
    model_.expressions.percent = percent;
    const view::Image shown = picture();
    // All that is bright in the row of the strength is its label and its number.
    EXPECT_EQ(bright_pixels(rows(shown, 142, 166), 552, 725), 0U) << percent;
  }
}

TEST_F(Panels, WhoComesBackToTheEditorSeesWhatIsEdited) {
  model_.editor.au = 12;
  model_.editor.aside = true;
  const GuiCommands during = click(590, 54);  // the tab
  EXPECT_FALSE(first_of<ShowEdited>(during).has_value()) << "a stream plays";
  EXPECT_TRUE(find_by_clicking<ShowEdited>(770, 400, 600).has_value()) << "but it is a click away";
  static_cast<void>(click(450, 54));  // another tab
  model_.playing.activity = Activity::Paused;
  EXPECT_TRUE(first_of<ShowEdited>(click(590, 54)).has_value());
  EXPECT_FALSE(first_of<ShowEdited>(frame()).has_value()) << "once";
  gui_->set_hidden(true);
  static_cast<void>(frame());
  gui_->set_hidden(false);
  EXPECT_FALSE(first_of<ShowEdited>(frame()).has_value()) << "the tab was only out of sight";
  model_.editor.aside = false;
  EXPECT_FALSE(find_by_clicking<ShowEdited>(770, 400, 600).has_value()) << "the face shows it";
}

TEST_F(Panels, AStreamFileIsSoughtPlayedAndSteppedFromTheBar) {
  const view::Image without = picture();
  model_.local = three_keyframes();
  EXPECT_NE(picture().rgba, without.rgba);
  const float edge = kWidth - gui_->covered_width();
  const auto seek = first_of<Seek>(click(edge / 2, kHeight - 82));
  ASSERT_TRUE(seek.has_value());
  EXPECT_NEAR(std::chrono::duration<double>(seek->position).count(), 0.3, 0.005);
  std::set<int> steps;
  bool plays = false;
  for (float x = 16; x < 220; x += 10) {
    const GuiCommands all = click(x, kHeight - 55);
    if (const auto step = first_of<StepKeyframe>(all)) steps.insert(10 * step->direction);
    if (const auto step = first_of<StepFrame>(all)) steps.insert(step->direction);
    for (const GuiCommand& one : all) plays |= command_if<Resume>(one) != nullptr;
  }
  EXPECT_EQ(steps, (std::set<int>{-10, -1, 1, 10}));
  EXPECT_TRUE(plays);
}

TEST_F(Panels, TheCameraIsStartedAndLetLiveOnItsTab) {
  static_cast<void>(click(745, 54));  // the tab
  const auto start = find_by_clicking<StartMirror>(480, 140, 170);
  ASSERT_TRUE(start.has_value());
  EXPECT_EQ(start->source, "camera");
  EXPECT_FALSE(find_by_clicking<GoLive>(480, 500, 600).has_value()) << "it is off";
  model_.mirror.phase = MirrorView::Phase::Private;
  model_.mirror.seen = std::make_shared<const preview::Seen>(
      preview::Seen{1, 1, {1, 2, 3}, {{0.5F, 0.5F}}, {{12, Side::Left, 40}}});
  const auto live = find_by_clicking<GoLive>(480, 500, 600);
  ASSERT_TRUE(live.has_value());
  EXPECT_EQ(live->bind, "127.0.0.1") << "nobody else unless it was asked for";
  EXPECT_FALSE(find_by_clicking<GoPrivate>(700, 500, 600).has_value());
  model_.mirror.phase = MirrorView::Phase::Live;
  EXPECT_TRUE(find_by_clicking<GoPrivate>(700, 500, 600).has_value());
  EXPECT_FALSE(find_by_clicking<GoLive>(480, 500, 600).has_value());
  EXPECT_TRUE(find_by_clicking<StopMirror>(700, 140, 170).has_value());
}

TEST_F(Panels, WhoBeginsWithTheCameraSeesItsTab) {
  end();
  model_.mirror.wanted = true;
  start();
  const view::Image begun = picture();
  static_cast<void>(click(745, 54));
  ImGui::GetIO().MousePos = ImVec2(10, 10);
  EXPECT_EQ(picture().rgba, begun.rgba);
}

TEST_F(Panels, AFaceIsComposedByClickingAndPutInARow) {
  model_.composer.rows = std::make_shared<const std::vector<TimelineRow>>();
  model_.composer.pad = std::make_shared<const std::vector<PadPoint>>();
  const auto composed = [](const GuiCommands& all, auto wanted) {
    using Wanted = decltype(wanted);
    std::optional<Wanted> found;
    for (const GuiCommand& command : all) {
      if (const auto* one = command_if<Wanted>(command)) found = *one;
    }
    return found;
  };
  static_cast<void>(click(637, 54));  // the tab
  std::optional<ComposeMood> mood;
  std::optional<ComposeAu> au;
  bool added = false;
  for (float y = 330; y < kHeight; y += 12) {
    const GuiCommands all = click(450, y);
    if (!mood) mood = composed(all, ComposeMood{});
    if (!au) au = composed(all, ComposeAu{});
    added |= composed(all, AddKeyframe{}).has_value();
  }
  EXPECT_TRUE(added);
  ASSERT_TRUE(mood.has_value());
  EXPECT_LT(mood->x, -0.8F) << "the sad side";
  EXPECT_GT(mood->y, 0.5F) << "the excited end";
  ASSERT_TRUE(au.has_value());
  EXPECT_EQ(au->number, 12);
  EXPECT_EQ(au->left_percent, 100);
}

TEST_F(Panels, TheFileDialogChoosesAFile) {
  model_.browser.open = true;
  model_.browser.folder = "/streams";
  model_.browser.entries = {{"more", true}, {"talk.txt", false}};
  static_cast<void>(picture());
  EXPECT_TRUE(find_by_clicking<EnterFolder>(200, 206, 254).has_value());
  for (float y = 206; y < 290; y += 10) static_cast<void>(click(200, y));
  const auto chosen = find_by_clicking<ChooseFile>(550, 560, 640);
  ASSERT_TRUE(chosen.has_value());
  EXPECT_EQ(chosen->file, "talk.txt");
  EXPECT_TRUE(find_by_clicking<CloseBrowser>(200, 560, 640).has_value());
}

TEST_F(Panels, LeavingWithUnsavedChangesIsAQuestion) {
  const view::Image before = picture();
  model_.asks_to_leave = true;
  EXPECT_NE(picture().rgba, before.rgba);
}

TEST_F(Panels, KeyframesHavePicturesWhereTheyAreSeen) {
  model_.composer.pad = std::make_shared<const std::vector<PadPoint>>();
  std::vector<TimelineRow> rows;
  for (int number = 1; number <= 60; ++number) {
    rows.push_back({std::to_string(number), "500 ms"});
  }
  model_.composer.rows = std::make_shared<const std::vector<TimelineRow>>(rows);
  EXPECT_TRUE(gui_->keyframes().seen.empty()) << "another tab is shown";
  static_cast<void>(click(637, 54));  // the tab
  const std::vector<std::string> seen = gui_->keyframes().seen;
  ASSERT_GT(seen.size(), 2U);
  EXPECT_LT(seen.size(), 10U) << "those that are scrolled away cost nothing";
  EXPECT_EQ(seen.front(), "1");
  const std::size_t plain = bright_pixels(picture(), 400, kWidth);
  GLuint white = 0;
  glGenTextures(1, &white);
  glBindTexture(GL_TEXTURE_2D, white);
  const std::array<std::uint8_t, 4> pixel{255, 255, 255, 255};
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gui_->keyframes().textures[seen.front()] = white;
  constexpr std::size_t kOfOne =
      9 * kKeyframeWidth * kKeyframeHeight / 10;  // its corners are round
  EXPECT_GT(bright_pixels(picture(), 400, kWidth), plain + kOfOne);
  const auto chosen = find_by_clicking<ChooseKeyframe>(560, 100, 300);
  ASSERT_TRUE(chosen.has_value());
  EXPECT_EQ(chosen->keyframe, 0);
  glDeleteTextures(1, &white);
  rows.push_back({"61", "500 ms"});
  model_.composer.rows = std::make_shared<const std::vector<TimelineRow>>(rows);
  static_cast<void>(picture());
  EXPECT_EQ(gui_->keyframes().seen.back(), "61") << "what was added is scrolled to";
  model_.composer.chosen = 29;
  static_cast<void>(picture());
  EXPECT_EQ(gui_->keyframes().seen.front(), "29") << "its edge, above the one chosen";
}

}  // namespace
}  // namespace aucast::gui
