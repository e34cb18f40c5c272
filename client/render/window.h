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

/// What a key is for; None: nothing. Slower and Faster, Quieter and Louder are pairs of keys.
enum class Key : int {
  None,
  Quit,
  Space,
  Escape,
  F,
  S,
  R,
  Question,
  P,
  Left,
  Right,
  Home,
  End,
  PageUp,
  PageDown,
  Comma,
  Period,
  Slower,
  Faster,
  L,
  Repeat,
  H,
  O,
  V,
  C,
  Mute,
  Quieter,
  Louder,
  Undo,
  Redo,
  Save
};

/// A mouse or keyboard event as GLFW reports it, for the panels.
struct InputEvent {
  enum class Kind : std::uint8_t { Key, Character, Button, Move, Leave, Scroll, Focus };
  Kind kind = Kind::Move;
  int code = 0;  ///< of the key or the button; the character; 1: the window has got the focus
  int scancode = 0;
  int action = 0;  ///< 0: released
  int modifiers = 0;
  double x = 0;  ///< position of the pointer, or how far the wheel turned
  double y = 0;
  Key meaning = Key::None;  ///< the player's command, unless a text field has the focus
  bool text = false;        ///< a key that only types a character
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
  /// Withdraws the user's request to close.
  void keep_open();
  /// Handles events that are there; waits at most `seconds_max` for one when it is above 0.
  void poll(double seconds_max);
  /// The next file dropped on the window; empty when there is none.
  [[nodiscard]] std::string next_dropped();
  void set_title(const std::string& title);
  /// Makes the window smaller where it is larger than the room that the screen has.
  void fit_to_screen();
  void toggle_full_screen();
  [[nodiscard]] bool full_screen() const;
  /// Binds the window's own framebuffer again.
  void bind_framebuffer();
  void present();
  /// The picture of the program in task bars.
  void set_icon(view::Image picture);
  /// All input in order; the reader removes what it has handled.
  [[nodiscard]] std::deque<InputEvent>& input();
  /// True once after something happened that may need a new picture: any input, resize, exposure.
  [[nodiscard]] bool take_redraw();
  [[nodiscard]] view::Viewpoint& viewpoint();
  void framebuffer_size(int& width, int& height) const;
  /// Scale of the screen: 1 at 96 dots an inch.
  [[nodiscard]] float scale() const;
  /// For the panels over the face. Owned by the window.
  [[nodiscard]] GLFWwindow* native();

 private:
  struct State;
  explicit Window(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace aucast::render
