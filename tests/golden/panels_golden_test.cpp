// What a user does, replayed without a display: mouse and keys reach the panels as ImGui has them,
// what the panels ask for reaches a real session, and what is then seen is compared with pictures.

#include <epoxy/gl.h>

#include <backends/imgui_impl_opengl3.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <sstream>

#include "client/app/window_session.h"
#include "client/gui/gui.h"
#include "client/render/offscreen.h"
#include "tests/golden/baseline.h"
#include "tests/support/manual_clock.h"
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
  }

  void open(float scale, std::unique_ptr<playback::KeyframeSource> source) {
    scale_ = scale;
    auto target = render::OffscreenTarget::create(scaled(kWidth), scaled(kHeight));
    ASSERT_TRUE(target) << target.error().message;
    target_ = std::move(*target);
    options_.playback.endpoint = "lecture.example.org";
    session_.emplace(*assets_, options_, std::move(source), stats_);
    gui_ = std::make_unique<gui::Gui>(scale);
    ASSERT_TRUE(ImGui_ImplOpenGL3_Init("#version 330 core"));
    frames(2);
  }

  /// The steps, one a line: "at MS" (time passes), "click X Y", "drag X Y X Y", "type TEXT",
  /// "wheel X Y STEPS". Places are pixels at scale 1.
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
      } else {
        FAIL() << "no such step: " << line;
      }
    }
  }

  /// The panel as it is now; the pointer out of its way.
  view::Image panel() {
    ImGui::GetIO().MousePos = ImVec2(1, 1);
    frames(2);
    frame(true);
    const view::Image all = target_->read();
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
      glViewport(0, 0, scaled(kWidth), scaled(kHeight));
      glClearColor(0, 0, 0, 1);
      glClear(GL_COLOR_BUFFER_BIT);
    }
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(kWidth * scale_, kHeight * scale_);
    io.DeltaTime = 1.0F / 60;
    ImGui_ImplOpenGL3_NewFrame();
    gui::GuiCommands commands;
    gui::GuiModel model = session_->model();
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
  std::optional<app::WindowSession> session_;
  std::function<void(gui::GuiModel&)> dress_;  ///< what only a network would bring
  std::unique_ptr<render::OffscreenContext> context_;
  std::unique_ptr<render::OffscreenTarget> target_;
  std::unique_ptr<gui::Gui> gui_;
};

std::unique_ptr<app::Assets> Replay::assets_;

/// Three keyframes, one of which the rules change.
std::unique_ptr<playback::KeyframeSource> small_stream() {
  auto source = std::make_unique<playback::test::ScriptedSource>();
  source->now.connected = true;
  const auto add = [&](std::initializer_list<AuTerm> terms) {
    source->keyframes.push_back(
        {frame_from_terms({terms.begin(), terms.size()}), Milliseconds(1000)});
  };
  add({{6, Side::Both, 80}, {12, Side::Both, 100}});
  add({{1, Side::Both, 100}, {51, Side::Both, 100}, {52, Side::Both, 40}});
  add({{4, Side::Both, 100}});
  return source;
}

void as_from_a_server(gui::GuiModel& model) {
  gui::RemoteView& remote = model.remote;
  remote.local = false;
  remote.receiver = {42, 100, 40};
  remote.playout = {12, 30, 0};
  remote.in = "54 packets, 893 B, 1.2 kbit/s";
  remote.out = "54 B, 80 bit/s";
  remote.protocol = "level 2";
  remote.receiver_history.clear();
  remote.au_history = {{6, {}}, {12, {}}};
  for (int i = 0; i < 100; ++i) {
    remote.receiver_history.push_back(std::min(0.6F, 0.01F * static_cast<float>(i)));
    remote.au_history[0].values.push_back(static_cast<float>(i % 20) / 20);
    remote.au_history[1].values.push_back(i % 40 < 20 ? 1.0F : 0.2F);
  }
}

TEST_F(Replay, AStreamPlaysAndTheMixerIsChanged) {
  dress_ = as_from_a_server;
  open(1, small_stream());
  replay("at 0\nat 250\nat 250\nat 250\nat 250\nat 250\nat 250\n");
  const gui::GuiModel model = session_->model();
  EXPECT_EQ(model.remote.state, "playing");
  EXPECT_EQ(model.remote.keyframe, "keyframe 2");
  test::expect_as_baseline(panel(), "panel_play", kTolerance, kShareMax);
}

TEST_F(Replay, TheViewIsSetByMouse) {
  open(1, nullptr);
  // The tab, then the boxes for wireframe and muscles, then a white ground.
  replay("click 673 54\nclick 638 211\nclick 638 273\nclick 757 373\n");
  const gui::RenderingSettings rendering = session_->rendering();
  EXPECT_TRUE(rendering.layers.wireframe);
  EXPECT_TRUE(rendering.layers.muscles);
  EXPECT_EQ(rendering.ground, gui::Ground::White);
  test::expect_as_baseline(panel(), "panel_view", kTolerance, kShareMax);
}

TEST_F(Replay, AtTwiceTheScaleAllIsTwiceAsFine) {
  open(2, small_stream());
  replay("at 0\nat 250\nclick 673 54\n");
  const view::Image fine = panel();
  EXPECT_EQ(fine.width, 2 * 380);
  test::expect_as_baseline(fine, "panel_view_twice", kTolerance, kShareMax);
}

}  // namespace
}  // namespace aucast
