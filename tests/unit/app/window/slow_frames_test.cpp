#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <deque>
#include <memory>

#include "client/app/window/input_pacer.h"
#include "client/app/window/panel_mouse.h"
#include "client/gui/gui.h"

namespace aucast {
namespace {

using render::InputEvent;
using Kind = InputEvent::Kind;

/// Panels that are drawn so seldom that whole clicks happen between two frames.
class SlowFrames : public testing::Test {
 protected:
  void SetUp() override {
    model_.known_aus = std::make_shared<const std::vector<gui::AuEntry>>();
    model_.expressions.buttons = {{"Happiness", "6,12"}};
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(800, 800);
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    frame();
  }

  void click(double x, double y) {
    comes({Kind::Move, 0, 0, 0, 0, x, y});
    comes({Kind::Button, 0, 0, 1});
    comes({Kind::Button, 0, 0, 0});
  }
  /// Since the last frame.
  void comes(InputEvent event) {
    event.after = now_ - kFrame;
    event.by = now_;
    input_.push_back(event);
  }
  void frame() {
    now_ += kFrame;
    ImGui::GetIO().DeltaTime = static_cast<float>(seconds(kFrame));
    for (std::size_t left = pacer_.next(input_, gui_.wants_keys()); left > 0; --left) {
      mouse_.take(input_.front());
      input_.pop_front();
    }
    mouse_.hand_over();
    gui_.draw(model_, commands_);
  }

  static constexpr Milliseconds kFrame{200};

  gui::Gui gui_{1};
  gui::GuiModel model_;
  gui::GuiCommands commands_;
  app::InputPacer pacer_;
  app::PanelMouse mouse_;
  Instant now_{};
  std::deque<InputEvent> input_;
};

TEST_F(SlowFrames, NoClickIsLost) {
  constexpr int kRounds = 50;
  for (int i = 0; i < kRounds; ++i) {
    click(516, 54);   // the tab of expressions
    click(470, 123);  // Happiness
    click(693, 54);   // the tab of the view
    click(470, 160);  // Front
    while (!input_.empty()) frame();
    frame();
  }
  int expressions = 0;
  int views = 0;
  for (const gui::GuiCommand& command : commands_) {
    expressions += gui::command_if<gui::ShowExpression>(command) != nullptr ? 1 : 0;
    views += gui::command_if<gui::LookFrom>(command) != nullptr ? 1 : 0;
  }
  EXPECT_EQ(expressions, kRounds);
  EXPECT_EQ(views, kRounds);
}

TEST_F(SlowFrames, ADoubleClickIsOneWhateverTheFrames) {
  model_.browser.open = true;
  model_.browser.folder = "/tmp";
  model_.browser.entries = {{"fear.txt", false}};
  for (int i = 0; i < 3; ++i) frame();
  const ImGuiWindow* const dialog = ImGui::FindWindowByID(ImHashStr("###files"));
  ASSERT_NE(dialog, nullptr);
  const double x = dialog->Pos.x + 60;
  const double y = dialog->Pos.y + 115;
  click(x, y);
  for (int i = 0; i < 5; ++i) frame();
  EXPECT_TRUE(commands_.empty()) << "it is chosen";
  click(x, y);  // a second later
  frame();      // the pointer comes
  frame();      // the press
  click(x, y);
  while (!input_.empty()) frame();
  int taken = 0;
  for (const gui::GuiCommand& command : commands_) {
    taken += gui::command_if<gui::ChooseFile>(command) != nullptr ? 1 : 0;
  }
  EXPECT_EQ(taken, 1);
}

}  // namespace
}  // namespace aucast
