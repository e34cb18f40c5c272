#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "client/view/image.h"
#include "client/view/scene.h"
#include "common/result.h"

struct GLFWwindow;

namespace aucast::render {

enum class Key : int {
  None,
  Quit,
  Space,
  Escape,
  F,
  S,
  R,
  Question,
  Tab,
  Left,
  Right,
  Comma,
  Period,
  Slower,
  Faster,
  L,
  O,
  V,
  Undo,
  Redo,
  Save
};

/// What mouse and keyboard did, as GLFW has it, for the panels.
struct InputEvent {
  enum class Kind : std::uint8_t { Key, Character, Button, Move, Leave, Scroll, Focus };
  Kind kind = Kind::Move;
  int code = 0;  ///< of the key or the button; the character; 1 when the focus came
  int scancode = 0;
  int action = 0;  ///< 0: released
  int modifiers = 0;
  double x = 0;  ///< place of the pointer, or how far the wheel turned
  double y = 0;
  Key meaning = Key::None;  ///< to the player, unless it is typed into something
  bool text = false;        ///< a key that says nothing but the character it comes with
};

/// A plain GLFW window with an OpenGL 3.3 core context and 4 samples. Thread: the main one.
class Window {
 public:
  /// Failed, saying what to do, when there is no display or no OpenGL 3.3.
  [[nodiscard]] static Result<std::unique_ptr<Window>> create(int width, int height,
                                                              const std::string& title);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  [[nodiscard]] bool should_close() const;
  void close();
  /// Takes the user's wish to close back.
  void keep_open();
  /// Handles events that are there; waits at most `seconds_max` for one when it is above 0.
  void poll(double seconds_max);
  /// A file that was dropped on the window since the last call; empty when there is none.
  [[nodiscard]] std::string next_dropped();
  void set_title(const std::string& title);
  void toggle_full_screen();
  /// Makes the window's own framebuffer the one that is drawn into again.
  void bind_framebuffer();
  void present();
  /// The picture of the program in task bars.
  void set_icon(view::Image picture);
  /// Everything that happened, in order; who reads it takes it out.
  [[nodiscard]] std::deque<InputEvent>& input();
  /// True once after something happened that may need a new picture: any input, resize, exposure.
  [[nodiscard]] bool take_redraw();
  [[nodiscard]] view::Camera& camera();
  void framebuffer_size(int& width, int& height) const;
  /// How large things should be drawn: 1 at 96 dots an inch.
  [[nodiscard]] float scale() const;
  /// For what draws over the face; stays the window's.
  [[nodiscard]] GLFWwindow* native();

 private:
  struct State;
  explicit Window(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace aucast::render
