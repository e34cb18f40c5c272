// The window's loop with everything but a screen.
#include "client/app/window/window_loop.h"

#include <cstdlib>
#include <deque>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "client/gui/storage/kept_settings.h"
#include "client/gui/texts/texts.h"
#include "tests/support/quiet_log.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/app/window/window_session_fixture.h"

namespace aucast::app {
namespace {

using render::Key;

template <typename T>
T next_of(std::deque<T>& waiting) {
  if (waiting.empty()) return T();
  T next = std::move(waiting.front());
  waiting.pop_front();
  return next;
}

/// Does what the test says, and notes what it is asked for.
class FakeDisplay : public WindowDisplay {
 public:
  void poll(Duration wait_max) override { waited = wait_max; }
  bool take_closing() override { return std::exchange(closing, false); }
  std::string next_dropped() override { return next_of(dropped); }
  Key next_key() override { return next_of(keys); }
  bool input_waits() const override { return input; }
  bool take_redraw(Instant) override { return std::exchange(redraw, false); }
  std::optional<Instant> redraws_at(Instant) const override { return redraws; }
  void set_title(const std::string& title) override { titles.push_back(title); }
  void look_from(view::ViewpointPreset preset) override { looked_from.push_back(preset); }
  void act(WindowAct act, Instant) override { acts.push_back(act); }
  gui::GuiCommands close_nearest(const gui::GuiModel&, Instant) override {
    ++closed;
    return std::exchange(left, {});
  }
  Result<void> change_face() override {
    ++faces;
    return problem ? Result<void>(*problem) : Result<void>();
  }
  bool make_thumbnails(const FaceOf&) override { return std::exchange(thumbnail, false); }
  bool thumbnails_wait() const override { return reads_face; }
  FrameTimes draw(const std::vector<float>& activations, const face::HairSway& sway, bool moved,
                  const view::Style&, const gui::GuiModel& model,
                  gui::GuiCommands& commands) override {
    ++drawn;
    pose = activations;
    hair = sway;
    poses += moved ? 1 : 0;
    shown = model;
    for (gui::GuiCommand& one : asked) commands.push_back(std::move(one));
    asked.clear();
    return {{}, Milliseconds(1), Milliseconds(2), Milliseconds(3)};
  }
  Result<view::Image> picture(int width, int height, Sharpness, const view::Style&) override {
    if (problem) return *problem;
    pictured = pose;
    return view::make_image(width, height);
  }
  void free_size(int& width, int& height) const override {
    width = 40;
    height = 30;
  }
  void whole_size(int& width, int& height) const override {
    width = 60;
    height = 30;
  }
  bool full_screen() const override { return full; }
  float scale() const override { return 1; }

  // What it says.
  bool closing = false;
  bool input = false;
  bool redraw = false;
  bool thumbnail = false;
  bool reads_face = false;
  bool full = false;
  std::deque<std::string> dropped;
  std::deque<Key> keys;
  std::optional<Instant> redraws;
  gui::GuiCommands asked;  ///< by the panels, in the next frame
  gui::GuiCommands left;   ///< by close_nearest()
  std::optional<Error> problem;
  // What it is asked for.
  std::optional<Duration> waited;
  int drawn = 0;
  int poses = 0;
  int faces = 0;
  int closed = 0;
  std::vector<float> pose;
  face::HairSway hair;
  std::vector<float> pictured;  ///< the pose in the last picture
  gui::GuiModel shown;
  std::vector<std::string> titles;
  std::vector<view::ViewpointPreset> looked_from;
  std::vector<WindowAct> acts;
};

/// The default face in a window, where nothing plays unless the test opens it.
class WindowLoopTest : public PlayedSession {
 protected:
  void SetUp() override {
    if (assets_ == nullptr) SetUpTestSuite();
    options_.playback.endpoint.clear();
    open_nothing();
  }
  WindowLoop& loop() {
    if (!loop_) {
      loop_.emplace(WindowLoop::Parts{*session_, display_, settings_, *assets_, options_, stats_,
                                      start_times_, [this] { return clock_.now(); }});
    }
    return *loop_;
  }
  void tick(int times = 1) {
    for (; times > 0; --times) loop().tick(false);
  }
  /// Until everything is drawn that is to be drawn.
  void settle() { tick(2 * gui::kFramesAfterChange); }
  [[nodiscard]] int drawn_by(int ticks) {
    const int before = display_.drawn;
    tick(ticks);
    return display_.drawn - before;
  }
  void press(Key key) {
    display_.keys.push_back(key);
    tick();
  }
  [[nodiscard]] std::filesystem::path stream() const {
    return folder_.write("two.txt", "Beg_Stream\n26;100\n0;200\nEnd_Stream\n");
  }
  [[nodiscard]] gui::KeptSettings on_disk() const { return gui::load_settings(file_).settings; }

  const test::QuietLog quiet_;
  test::TempFolder folder_;
  std::filesystem::path file_ = folder_.path() / "face-player.toml";
  WindowSettings settings_{options_, file_};
  StartTimes start_times_;
  FakeDisplay display_;
  std::optional<WindowLoop> loop_;
};

// === When it draws, and how long it sleeps.

TEST_F(WindowLoopTest, AFaceThatStandsIsDrawnUntilAllIsInItsPlaceAndNotAgain) {
  EXPECT_EQ(drawn_by(10), gui::kFramesAfterChange);
  EXPECT_EQ(display_.poses, 1);
  EXPECT_EQ(stats_.frames_drawn, static_cast<std::uint64_t>(gui::kFramesAfterChange));
  EXPECT_NEAR(stats_.draw_seconds, 0.006 * gui::kFramesAfterChange, 1e-9);
}

TEST_F(WindowLoopTest, SleepsOnlyWhenNothingIsToBeDrawn) {
  for (int i = 0; i < gui::kFramesAfterChange; ++i) {
    tick();
    EXPECT_EQ(display_.waited, Duration::zero());
  }
  tick();
  EXPECT_EQ(display_.waited, session_->idle_time(clock_.now()));
  EXPECT_GT(*display_.waited, Duration::zero());
}

TEST_F(WindowLoopTest, SleepsNoLongerThanWhatItWaitsFor) {
  settle();
  display_.redraws = clock_.now() + Milliseconds(7);
  tick();
  EXPECT_EQ(display_.waited, Milliseconds(7)) << "panels that go away";
  display_.redraws.reset();
  display_.reads_face = true;
  tick();
  EXPECT_EQ(display_.waited, kFrameMax) << "a small picture";
}

TEST_F(WindowLoopTest, WhatHappensInTheWindowIsDrawn) {
  settle();
  display_.redraw = true;
  EXPECT_EQ(drawn_by(10), gui::kFramesAfterChange) << "input, or another size";
  display_.thumbnail = true;
  EXPECT_EQ(drawn_by(10), gui::kFramesAfterChange) << "a small picture that was made";
  session_->notices().say("hello", false, clock_.now());
  EXPECT_EQ(drawn_by(10), gui::kFramesAfterChange) << "a model that changed";
  EXPECT_EQ(display_.shown.notice.text, "hello");
}

TEST_F(WindowLoopTest, InputThatOnlyTheNextFrameMaySeeKeepsItDrawing) {
  settle();
  display_.input = display_.redraw = true;
  EXPECT_EQ(drawn_by(10), 10);
  display_.input = false;
  EXPECT_EQ(drawn_by(10), gui::kFramesAfterChange);
}

TEST_F(WindowLoopTest, AFaceThatMovesIsPosedInEachPicture) {
  open({frame({{26, Side::Both, 100}})});
  settle();
  const int poses = display_.poses;
  for (int i = 0; i < 4; ++i) {
    clock_.advance(Milliseconds(20));
    tick();
  }
  EXPECT_EQ(display_.poses, poses + 4);
  EXPECT_EQ(display_.pose, session_->face().activations(clock_.now()));
}

TEST_F(WindowLoopTest, HairThatSwingsOnIsDrawnUntilItIsAtRest) {
  open({frame({{51, Side::Both, 100}})});
  for (int i = 0; i < 10; ++i) {
    clock_.advance(Milliseconds(20));
    tick();
  }
  const std::vector<float> face = display_.pose;
  const int poses = display_.poses;
  clock_.advance(Milliseconds(20));
  tick();
  EXPECT_EQ(display_.pose, face);
  EXPECT_EQ(display_.poses, poses + 1);
  EXPECT_NE(display_.hair, face::HairSway{});
  clock_.advance(pipeline::HairSwing::kMemory);
  tick();
  EXPECT_EQ(display_.hair, face::HairSway{});
  const int rest = display_.poses;
  clock_.advance(Milliseconds(20));
  tick();
  EXPECT_EQ(display_.poses, rest);
}

TEST_F(WindowLoopTest, TheTitleIsSetWhenItChanges) {
  settle();
  EXPECT_EQ(display_.titles, std::vector<std::string>{"AUcast"});
  display_.dropped.push_back(stream());
  settle();
  ASSERT_GE(display_.titles.size(), 2U);
  EXPECT_NE(display_.titles.back().find("two.txt"), std::string::npos) << display_.titles.back();
}

// === What the user asks for.

TEST_F(WindowLoopTest, WhatPanelsAskForIsCarriedOutAndDrawn) {
  settle();
  display_.redraw = true;
  display_.asked = {gui::Browse{gui::Purpose::PlayStream},
                    gui::LookFrom{view::ViewpointPreset::Profile}};
  tick();
  EXPECT_TRUE(model_of(*session_).browser.open);
  EXPECT_EQ(display_.looked_from, std::vector{view::ViewpointPreset::Profile});
  tick();
  EXPECT_TRUE(display_.shown.browser.open);
  EXPECT_EQ(display_.looked_from.size(), 1U) << "once";
}

TEST_F(WindowLoopTest, KeysActOnTheWindowAndOnTheSession) {
  settle();
  press(Key::F);
  press(Key::H);
  EXPECT_EQ(display_.acts, (std::vector{WindowAct::ToggleFullScreen, WindowAct::ToggleBare}));
  press(Key::O);
  EXPECT_TRUE(model_of(*session_).browser.open);
  const int volume = model_of(*session_).sound.volume;
  press(Key::Quieter);
  EXPECT_LT(model_of(*session_).sound.volume, volume);
  EXPECT_EQ(drawn_by(10), gui::kFramesAfterChange) << "a key may have changed anything";
}

TEST_F(WindowLoopTest, EscapeClosesOneThing) {
  settle();
  session_->notices().say("hello", false, clock_.now());
  display_.left = {gui::CloseNotice{}};
  press(Key::Escape);
  EXPECT_EQ(display_.closed, 1);
  EXPECT_EQ(model_of(*session_).notice.text, "");
  EXPECT_FALSE(loop().done());
}

TEST_F(WindowLoopTest, AFileThatIsDroppedPlays) {
  display_.dropped.push_back(stream());
  tick();
  EXPECT_TRUE(model_of(*session_).local.open);
}

// === Leaving.

TEST_F(WindowLoopTest, ClosesAtOnceWhenNothingIsUnsaved) {
  tick();
  EXPECT_FALSE(loop().done());
  display_.closing = true;
  tick();
  EXPECT_TRUE(loop().done());
}

TEST_F(WindowLoopTest, AsksBeforeItClosesOnUnsavedWorkHoweverOftenItIsClosed) {
  ask(gui::SetChannel{channel("jaw"), 1, false});
  display_.closing = true;
  tick();
  EXPECT_FALSE(loop().done());
  EXPECT_TRUE(display_.shown.asks_to_leave);
  press(Key::Quit);
  display_.closing = true;
  tick();
  EXPECT_FALSE(loop().done());
  EXPECT_TRUE(display_.shown.asks_to_leave);
  ask(gui::Leave{true});
  tick();
  EXPECT_TRUE(loop().done());
}

TEST_F(WindowLoopTest, StoppedFromOutsideItLeavesWithoutAQuestion) {
  ask(gui::SetChannel{channel("jaw"), 1, false});
  loop().tick(true);
  EXPECT_TRUE(loop().done());
  EXPECT_TRUE(loop().outcome());
}

TEST_F(WindowLoopTest, TheEndOfPlayingIsTheEndOnlyWhenThatIsWanted) {
  open({});
  source_->now.end = playback::EndReason::EndOfStream;
  settle();
  ASSERT_TRUE(session_->playback().over());
  EXPECT_FALSE(loop().done());
  options_.exit_at_end = true;
  EXPECT_TRUE(loop().done());
}

// === The face.

TEST_F(WindowLoopTest, AnotherFaceIsMadeAnewAlsoWhenAKeyHasSavedIt) {
  ASSERT_EQ(::setenv("XDG_DATA_HOME", folder_.path().c_str(), 1), 0);
  settle();
  ask(gui::LoadAu{12});
  settle();
  const int poses = display_.poses;
  press(Key::Save);
  EXPECT_EQ(display_.faces, 1) << model_of(*session_).notice.text;
  tick();
  EXPECT_EQ(display_.poses, poses + 1) << "it has no pose yet";
  EXPECT_EQ(display_.faces, 1);
  ASSERT_EQ(::unsetenv("XDG_DATA_HOME"), 0);
  loop_.reset();
  session_.reset();
  assets_.reset();  // whose face is the copy now
}

TEST_F(WindowLoopTest, AFaceThatCannotBeShownIsTheEndAndSaysWhy) {
  settle();
  display_.problem = Error{ErrorKind::Failed, "no memory on the graphics card"};
  display_.dropped.push_back(assets_->face_folder / "face.toml");
  display_.dropped.push_back(stream());
  const int drawn = display_.drawn;
  tick();
  EXPECT_TRUE(loop().done());
  ASSERT_FALSE(loop().outcome());
  EXPECT_EQ(loop().outcome().error().message, "no memory on the graphics card");
  EXPECT_EQ(display_.drawn, drawn) << "there is nothing to draw with";
  EXPECT_FALSE(model_of(*session_).local.open) << "and nothing else is begun";
}

// === What is kept.

TEST_F(WindowLoopTest, AFileThatWasOpenedIsRememberedAtOnce) {
  settle();
  EXPECT_FALSE(std::filesystem::exists(file_)) << "nothing is worth it yet";
  const std::string opened = stream();
  display_.dropped.push_back(opened);
  tick();
  EXPECT_EQ(on_disk().recent_files, std::vector{opened});
}

TEST_F(WindowLoopTest, SettingsAreRememberedAtTheEnd) {
  settle();
  gui::RenderingSettings rendering = session_->settings().rendering();
  rendering.light_percent = 50;
  ask(gui::ChangeRendering{rendering});
  settle();
  EXPECT_FALSE(std::filesystem::exists(file_));
  loop().finish();
  EXPECT_EQ(on_disk().rendering.light_percent, 50);
}

// === Pictures.

TEST_F(WindowLoopTest, APictureIsAsLargeAsTheFaceInTheWindowOrAsTheSettingsSay) {
  gui::PictureSettings pictures;
  pictures.folder = folder_.path();
  pictures.pattern = "it-{number}";
  ask(gui::ChangePictures{pictures});
  press(Key::S);
  tick();
  const auto first = view::read_png(folder_.path() / "it-1.png");
  ASSERT_TRUE(first) << first.error().message;
  EXPECT_EQ(first->width, 40);
  EXPECT_EQ(first->height, 30);
  EXPECT_EQ(model_of(*session_).notice.text,
            gui::tr("said.picture", (folder_.path() / "it-1.png").string()));
  pictures.width = 64;
  pictures.height = 48;
  ask(gui::ChangePictures{pictures});
  press(Key::S);
  tick();
  const auto second = view::read_png(folder_.path() / "it-2.png");
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_EQ(second->width, 64);
}

TEST_F(WindowLoopTest, InFullScreenAPictureIsAsLargeAsTheScreenWhereverThePanelIs) {
  gui::PictureSettings pictures;
  pictures.folder = folder_.path();
  pictures.pattern = "full";
  ask(gui::ChangePictures{pictures});
  display_.full = true;
  press(Key::S);
  tick();
  const auto picture = view::read_png(folder_.path() / "full.png");
  ASSERT_TRUE(picture) << picture.error().message;
  EXPECT_EQ(picture->width, 60);
}

TEST_F(WindowLoopTest, APictureHasFaceAndNameOfOneMoment) {
  gui::PictureSettings pictures;
  pictures.folder = folder_.path();
  pictures.pattern = "{aus}";
  ask(gui::ChangePictures{pictures});
  ask(gui::OpenStream{stream().string()});
  tick();
  clock_.advance(Milliseconds(50));
  tick();
  ask(gui::LoadAu{12});
  ask(gui::SetChannel{channel("jaw"), 2, false});
  settle();
  const std::vector<float> edited = display_.pose;
  display_.keys = {Key::Space, Key::S};
  tick(2);
  EXPECT_FALSE(model().editor.active);
  EXPECT_NE(display_.pictured, edited) << "the file plays again";
  EXPECT_EQ(display_.pictured, session_->face().activations(clock_.now()));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "au12_edited.png"));
}

TEST_F(WindowLoopTest, APictureIsTakenAlthoughOneLeavesAtOnce) {
  gui::PictureSettings pictures;
  pictures.folder = folder_.path();
  pictures.pattern = "last";
  ask(gui::ChangePictures{pictures});
  display_.keys = {Key::S, Key::Quit};
  tick();
  ASSERT_TRUE(loop().done());
  loop().finish();
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "last.png"));
}

TEST_F(WindowLoopTest, APictureThatCannotBeMadeIsSaid) {
  settle();
  display_.problem = Error{ErrorKind::Failed, "too large for this driver"};
  press(Key::S);
  tick();
  EXPECT_TRUE(model_of(*session_).notice.bad);
  EXPECT_EQ(model_of(*session_).notice.text, "too large for this driver");
  EXPECT_FALSE(loop().done());
}

}  // namespace
}  // namespace aucast::app
