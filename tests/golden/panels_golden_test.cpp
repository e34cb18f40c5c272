// What a user does, replayed without a display: mouse and keys reach the panels as ImGui has them,
// what the panels ask for reaches a real session, and what is then seen is compared with pictures.

#include <epoxy/gl.h>

#include <backends/imgui_impl_opengl3.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <sstream>

#include "client/app/window/window_model.h"
#include "client/app/window/window_session.h"
#include "client/face/face_folder.h"
#include "client/gui/gui.h"
#include "client/gui/texts/texts.h"
#include "client/playback/source_playback.h"
#include "client/render/offscreen_context.h"
#include "client/render/offscreen_target.h"
#include "tests/golden/baseline.h"
#include "tests/support/manual_clock.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/playback/scripted_source.h"

namespace aucast {
namespace {

constexpr int kWidth = 800;
constexpr int kHeight = 800;
/// Letters are drawn by the font's own outlines: alike everywhere but for rounding.
constexpr int kTolerance = 24;
constexpr double kShareMax = 0.01;

/// A session and its panels, without a window.
class Replay : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto loaded = app::load_assets({});
    ASSERT_TRUE(loaded) << loaded.error().message;
    assets_ = std::move(*loaded);
  }
  static void TearDownTestSuite() { assets_.reset(); }

  void SetUp() override {
    auto context = render::OffscreenContext::create();
    ASSERT_TRUE(context) << context.error().message;
    context_ = std::move(*context);
  }
  void TearDown() override {
    if (gui_) ImGui_ImplOpenGL3_Shutdown();
    gui_.reset();
    target_.reset();
    gui::use_english();
  }

  void open(float scale, std::unique_ptr<playback::Playback> playback) {
    scale_ = scale;
    auto target = render::OffscreenTarget::create(scaled(kWidth), scaled(height_));
    ASSERT_TRUE(target) << target.error().message;
    target_ = std::move(*target);
    options_.playback.endpoint = "lecture.example.org";
    session_.emplace(*assets_, options_, std::move(playback), stats_);
    gui_ = std::make_unique<gui::Gui>(scale);
    ASSERT_TRUE(ImGui_ImplOpenGL3_Init("#version 330 core"));
    frames(2);
  }

  /// The steps, one a line: "at MS" (time passes), "click X Y", "drag X Y X Y", "type TEXT",
  /// "wheel X Y STEPS", "undo", "redo", "save" (the keys). Places are pixels at scale 1.
  void replay(const std::string& script) {
    std::istringstream lines(script);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string verb;
      words >> verb;
      ImGuiIO& io = ImGui::GetIO();
      std::array<float, 4> n{};
      if (verb == "type") {
        std::string text;
        words >> text;
        io.AddInputCharactersUTF8(text.c_str());
        frames(2);
        continue;
      }
      for (float& value : n) words >> value;
      if (verb == "at") {
        clock_.advance(Milliseconds(static_cast<int>(n[0])));
        session_->advance(clock_.now());
        frames(1);
      } else if (verb == "click" || verb == "drag") {
        io.MousePos = ImVec2(n[0] * scale_, n[1] * scale_);
        frames(2);
        io.MouseDown[0] = true;
        frames(2);
        if (verb == "drag") io.MousePos = ImVec2(n[2] * scale_, n[3] * scale_);
        frames(2);
        io.MouseDown[0] = false;
        frames(2);
      } else if (verb == "wheel") {
        io.MousePos = ImVec2(n[0] * scale_, n[1] * scale_);
        frames(1);
        io.MouseWheel = n[2];
        frames(2);
      } else if (verb == "undo" || verb == "redo" || verb == "save") {
        if (verb == "undo") session_->undo(clock_.now());
        if (verb == "redo") session_->redo(clock_.now());
        if (verb == "save") session_->save(clock_.now());
        frames(2);
      } else {
        FAIL() << "no such step: " << line;
      }
    }
  }

  /// All that lies over the face, on black; the pointer out of its way.
  view::Image overlay() {
    ImGui::GetIO().MousePos = ImVec2(1, 1);
    frames(2);
    frame(true);
    return target_->read();
  }

  /// The panel alone.
  view::Image panel() {
    const view::Image all = overlay();
    const int left = all.width - static_cast<int>(gui_->covered_width());
    view::Image cut = view::make_image(all.width - left, all.height);
    view::paste(cut, all, -left, 0);
    return cut;
  }

  void frames(int count) {
    for (int i = 0; i < count; ++i) frame(false);
  }
  void frame(bool pixels) {
    if (pixels) {
      target_->bind();
      glViewport(0, 0, scaled(kWidth), scaled(height_));
      glClearColor(0, 0, 0, 1);
      glClear(GL_COLOR_BUFFER_BIT);
    }
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(kWidth * scale_, static_cast<float>(height_) * scale_);
    io.DeltaTime = 1.0F / 60;
    gui::GuiModel model = model_of(*session_);
    if (gui_->prepare(model.display)) {
      ImGui_ImplOpenGL3_DestroyFontsTexture();
      ImGui_ImplOpenGL3_CreateFontsTexture();
    }
    ImGui_ImplOpenGL3_NewFrame();
    gui::GuiCommands commands;
    if (dress_) dress_(model);
    gui_->draw(model, commands);
    if (pixels) ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    for (const gui::GuiCommand& command : commands) session_->apply(command, clock_.now());
  }
  [[nodiscard]] int scaled(int length) const {
    return static_cast<int>(static_cast<float>(length) * scale_);
  }

  static std::unique_ptr<app::Assets> assets_;
  app::PlayerOptions options_;
  app::PlayerStats stats_;
  test::ManualClock clock_;
  float scale_ = 1;
  int height_ = kHeight;
  std::optional<app::WindowSession> session_;
  std::function<void(gui::GuiModel&)> dress_;  ///< what only a network would bring
  std::unique_ptr<render::OffscreenContext> context_;
  std::unique_ptr<render::OffscreenTarget> target_;
  std::unique_ptr<gui::Gui> gui_;
};

std::unique_ptr<app::Assets> Replay::assets_;

/// Three keyframes, one of which the rules change.
std::unique_ptr<playback::Playback> small_stream() {
  auto source = std::make_unique<playback::test::ScriptedSource>();
  source->now.connected = true;
  const auto add = [&](std::initializer_list<AuTerm> terms) {
    source->keyframes.push_back(
        {frame_from_terms({terms.begin(), terms.size()}), Milliseconds(1000)});
  };
  add({{6, Side::Both, 80}, {12, Side::Both, 100}});
  add({{1, Side::Both, 100}, {51, Side::Both, 100}, {52, Side::Both, 40}});
  add({{4, Side::Both, 100}});
  return std::make_unique<playback::SourcePlayback>(std::move(source),
                                                    playback::SourcePlayback::Options{});
}

void as_from_a_server(gui::GuiModel& model) {
  gui::PlayingView& playing = model.playing;
  playing.local = false;
  playing.receiver = {42, 100, 40};
  playing.playout = {12, 30, 0};
  playing.in = "54 packets, 893 B, 1.2 kbit/s";
  playing.out = "54 B, 80 bit/s";
  playing.protocol = "level 2, live";
  playing.delay = "42 ms (at most 57, wanted 41)";
  playing.receiver_history.clear();
  playing.au_history = {{6, {}}, {12, {}}};
  for (int i = 0; i < 100; ++i) {
    playing.receiver_history.push_back(std::min(0.6F, 0.01F * static_cast<float>(i)));
    playing.au_history[0].values.push_back(static_cast<float>(i % 20) / 20);
    playing.au_history[1].values.push_back(i % 40 < 20 ? 1.0F : 0.2F);
  }
}

TEST_F(Replay, AStreamPlaysAndTheMixerIsChanged) {
  dress_ = as_from_a_server;
  open(1, small_stream());
  replay("at 0\nat 250\nat 250\nat 250\nat 250\nat 250\nat 250\n");
  const gui::GuiModel model = model_of(*session_);
  EXPECT_EQ(model.playing.state, "playing");
  EXPECT_EQ(model.playing.keyframe, "keyframe 2");
  test::expect_as_baseline(panel(), "panel_play", kTolerance, kShareMax);
}

TEST_F(Replay, TheViewIsSetByMouse) {
  open(1, nullptr);
  // The tab, then the boxes for wireframe and muscles, then a white ground.
  replay("click 693 54\nclick 638 485\nclick 638 547\nclick 729 647\n");
  const gui::RenderingSettings rendering = session_->settings().rendering();
  EXPECT_TRUE(rendering.layers.wireframe);
  EXPECT_TRUE(rendering.layers.muscles);
  EXPECT_EQ(rendering.ground, gui::Ground::White);
  test::expect_as_baseline(panel(), "panel_view", kTolerance, kShareMax);
}

TEST_F(Replay, AtTwiceTheScaleAllIsTwiceAsFine) {
  open(2, small_stream());
  replay("at 0\nat 250\nclick 693 54\n");
  const view::Image fine = panel();
  EXPECT_EQ(fine.width, 2 * 380);
  test::expect_as_baseline(fine, "panel_view_twice", kTolerance, kShareMax);
}

TEST_F(Replay, InFrenchAllHasRoom) {
  dress_ = as_from_a_server;
  open(1, small_stream());
  session_->apply(gui::ChangeDisplay{{"fr", 100}}, clock_.now());
  replay("at 0\nat 250\nat 250\nat 250\nat 250\nat 250\nat 250\n");
  EXPECT_EQ(model_of(*session_).playing.state, "lecture");
  test::expect_as_baseline(panel(), "panel_play_french", kTolerance, kShareMax);
  replay("click 620 54\n");
  test::expect_as_baseline(panel(), "panel_compose_french", kTolerance, kShareMax);
}

TEST_F(Replay, TheChartOfTheBufferSaysWhatItsEdgesAre) {
  dress_ = [](gui::GuiModel& model) {
    as_from_a_server(model);
    // Seven sets at most, of a hundred: a flat line unless the scale is theirs.
    for (float& fill : model.playing.receiver_history) fill *= 0.12F;
    model.playing.receiver = {7, 100, 8};
  };
  open(1, small_stream());
  replay("at 0\nat 250\nclick 670 424\n");
  test::expect_as_baseline(panel(), "panel_play_buffers", kTolerance, kShareMax);
}

TEST_F(Replay, ACurveHasTheNameOfItsAu) {
  const auto curves = std::make_shared<const gui::AuCurves>(gui::AuCurves{
      {1, {0, 1, 0}}, {12, {1, 0.2F, 1}}, {26, {0.5F, 0.5F, 0}}, {51, {0, 0.1F, 0.8F}}});
  const auto ends = std::make_shared<const std::vector<Duration>>(
      std::vector<Duration>{Milliseconds(500), Milliseconds(1500), Milliseconds(3000)});
  dress_ = [&](gui::GuiModel& model) {
    model.playing.local = true;
    model.local.open = true;
    model.local.name = "talk.txt";
    model.local.curves = curves;
    model.local.ends = ends;
    model.local.total = Milliseconds(3000);
    model.local.position = Milliseconds(1200);
  };
  open(1, nullptr);
  replay("at 0\n");
  test::expect_as_baseline(panel(), "panel_curves", kTolerance, kShareMax);
}

TEST_F(Replay, LettersOfTwiceTheSizeHaveRoomInASmallWindow) {
  dress_ = as_from_a_server;
  height_ = 600;
  open(1, small_stream());
  session_->apply(gui::ChangeDisplay{{"en", 200}}, clock_.now());
  replay("at 0\nat 250\nat 250\n");
  EXPECT_EQ(gui_->covered_width(), 560);
  test::expect_as_baseline(overlay(), "panel_play_large", kTolerance, kShareMax);
}

/// What the user makes goes into a folder that is gone afterwards; pictures say "/home/anna".
class Making : public Replay {
 protected:
  void SetUp() override {
    Replay::SetUp();
    ::setenv("XDG_DATA_HOME", folder_.path().c_str(), 1);
    before_ = std::filesystem::current_path();
    std::filesystem::create_directory(folder_.path() / "streams");
    std::filesystem::current_path(folder_.path() / "streams");
    dress_ = [this](gui::GuiModel& model) {
      for (std::string* text : {&model.browser.folder, &model.notice.text}) {
        const std::string here = folder_.path().string();
        for (auto at = text->find(here); at != std::string::npos; at = text->find(here)) {
          text->replace(at, here.size(), "/home/anna");
        }
      }
    };
  }
  void TearDown() override {
    std::filesystem::current_path(before_);
    ::unsetenv("XDG_DATA_HOME");
    Replay::TearDown();
  }
  [[nodiscard]] float shown(const char* channel) {
    return session_->face().activations(clock_.now())[*assets_->face.channel_index(channel)];
  }

  test::TempFolder folder_;
  std::filesystem::path before_;
};

TEST_F(Making, AnExpressionIsShownAndAusArePutTogether) {
  open(1, nullptr);
  // The tab, Happiness, then two AUs that the rules change.
  replay("click 516 54\nclick 590 154\nat 300\n");
  EXPECT_GT(shown("left_zygomaticus_major"), 0.5F);
  replay("click 550 537\ntype 51,52:40\nclick 744 537\nat 300\n");
  EXPECT_FLOAT_EQ(shown("head_turn_left"), 0.6F);
  EXPECT_EQ(shown("left_zygomaticus_major"), 0);
  test::expect_as_baseline(panel(), "panel_expression", kTolerance, kShareMax);
}

TEST_F(Making, AnAuIsEditedAndSaved) {
  open(1, nullptr);
  // The tab, then AU 12 from the list: what it drives is opened.
  replay("click 577 54\nclick 655 123\nclick 655 368\n");
  EXPECT_EQ(model_of(*session_).editor.au, 12);
  const float before = shown("left_cheek_raiser");
  // The cheeks by drag, one step more by button, which is taken back.
  replay("drag 665 578 693 578\n");
  const float dragged = shown("left_cheek_raiser");
  EXPECT_GT(dragged, before + 0.2F);
  EXPECT_EQ(shown("right_cheek_raiser"), dragged) << "left and right together";
  replay("click 770 578\n");
  EXPECT_NEAR(shown("left_cheek_raiser"), dragged + 0.05F, 0.006F);
  replay("click 475 154\n");
  EXPECT_EQ(shown("left_cheek_raiser"), dragged);
  EXPECT_TRUE(model_of(*session_).editor.unsaved);
  test::expect_as_baseline(panel(), "panel_editor", kTolerance, kShareMax);
  replay("click 727 185\n");
  EXPECT_FALSE(model_of(*session_).editor.unsaved);
  const auto mine = face::load_face(folder_.path() / "aucast" / "faces" / "default", {});
  ASSERT_TRUE(mine) << mine.error().message;
  EXPECT_NEAR(mine->recordings.at(12).activation[*mine->channel_index("left_cheek_raiser")],
              dragged, 0.006F);
  test::expect_as_baseline(panel(), "panel_editor_saved", kTolerance, kShareMax);
}

TEST_F(Making, AStreamIsComposedSavedAndPlayed) {
  open(1, nullptr);
  // The tab; AUs 12 and 6, of which 6 is drawn down; added. Then a face from the pad, added.
  replay("click 637 54\nclick 766 597\nclick 576 597\ndrag 726 756 645 756\nclick 475 394\n");
  ASSERT_EQ(model_of(*session_).composer.rows->size(), 1U);
  replay("click 639 460\nclick 766 425\nclick 475 394\n");
  ASSERT_EQ(model_of(*session_).composer.rows->size(), 2U);
  // The first is moved behind the second, which is taken back.
  replay("click 560 170\nclick 651 304\n");
  EXPECT_EQ(model_of(*session_).composer.chosen, 1);
  replay("undo\n");
  test::expect_as_baseline(panel(), "panel_compose", kTolerance, kShareMax);
  // Save asks where to.
  replay("click 651 123\n");
  test::expect_as_baseline(overlay(), "dialog_save", kTolerance, kShareMax);
  replay("click 550 630\n");
  EXPECT_EQ(folder_.read("streams/composed.txt"),
            "Beg_Stream\n6:11,12;500\n1,2,5:25,26;550\nEnd_Stream\n");
  EXPECT_FALSE(model_of(*session_).composer.unsaved);
  replay("click 475 304\nat 10\nat 250\n");
  EXPECT_EQ(model_of(*session_).playing.state, "playing");
  EXPECT_GT(shown("left_zygomaticus_major"), 0.3F);
}

TEST_F(Making, TheComposerAtTwiceTheScale) {
  open(2, nullptr);
  replay("click 637 54\nclick 766 597\nclick 576 597\nclick 475 394\nclick 639 460\n");
  ASSERT_EQ(model_of(*session_).composer.rows->size(), 1U);
  test::expect_as_baseline(panel(), "panel_compose_twice", kTolerance, kShareMax);
}

TEST_F(Making, AFileIsChosenInTheDialog) {
  folder_.write("streams/smile.txt", "Beg_Stream\n12\nEnd_Stream\n");
  folder_.write("streams/talk.txt", "Beg_Stream\n25\nEnd_Stream\n");
  std::filesystem::create_directory(folder_.path() / "streams" / "lectures");
  open(1, nullptr);
  session_->apply(gui::Browse{gui::Purpose::ComposeStream}, clock_.now());
  session_->apply(gui::EnterFolder{(folder_.path() / "streams").string()}, clock_.now());
  frames(2);
  test::expect_as_baseline(overlay(), "dialog_open", kTolerance, kShareMax);
}

TEST_F(Making, TheKeysAreListed) {
  open(1, nullptr);
  gui_->toggle_keys();
  test::expect_as_baseline(overlay(), "keys", kTolerance, kShareMax);
}

}  // namespace
}  // namespace aucast
