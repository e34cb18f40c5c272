#include <gtest/gtest.h>
#include <imgui.h>

#include <deque>
#include <memory>

#include "client/app/window/input_pacer.h"
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
    input_.push_back({Kind::Move, 0, 0, 0, 0, x, y});
    input_.push_back({Kind::Button, 0, 0, 1});
    input_.push_back({Kind::Button, 0, 0, 0});
  }
  /// A fifth of a second has passed.
  void frame() {
    ImGuiIO& io = ImGui::GetIO();
    io.DeltaTime = 0.2F;
    for (std::size_t left = pacer_.next(input_); left > 0; --left) {
      const InputEvent& event = input_.front();
      if (event.kind == Kind::Move) {
        io.MousePos = ImVec2(static_cast<float>(event.x), static_cast<float>(event.y));
      } else {
        io.MouseDown[0] = event.action != 0;
      }
      input_.pop_front();
    }
    gui_.draw(model_, commands_);
  }

  gui::Gui gui_{1};
  gui::GuiModel model_;
  gui::GuiCommands commands_;
  app::InputPacer pacer_;
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

}  // namespace
}  // namespace aucast
