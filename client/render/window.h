#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "client/view/image.h"
#include "client/view/scene.h"
#include "common/result.h"
#include "common/time.h"

struct GLFWwindow;

namespace aucast::render {

/// The commands that keys give; None: the key gives none.
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
  int code = 0;  ///< Key, Button: as in GLFW; Character: the character; Focus: 1 if the window has
                 ///< got the focus
  int scancode = 0;
  int action = 0;  ///< as in GLFW; 0: released
  int modifiers = 0;
  double x = 0;  ///< position of the pointer, or how far the wheel turned (Scroll)
  double y = 0;
  Key meaning = Key::None;  ///< the command that the key gives, unless a text field has the focus
  bool text = false;        ///< the key only types a character
  /// The event came after `after` and no later than `by`: a window looks for events only between
  /// frames.
  Instant after{};
  Instant by{};
};

/// A plain GLFW window with an OpenGL 3.3 core context and 4 samples. Thread: the main one.
class Window {
 public:
  /// Fails if there is no display or no OpenGL 3.3; the message says what to do.
  [[nodiscard]] static Result<std::unique_ptr<Window>> create(int width, int height,
                                                              const std::string& title);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  [[nodiscard]] bool should_close() const;
  /// Withdraws the user's request to close.
  void keep_open();
  /// Handles the events that have come. If there are none, waits for one for at most `wait_max`.
  /// `clock` gives the times of the input.
  void poll(Duration wait_max, Instant (*clock)());
  /// The path of the next file dropped on the window; empty: none.
  [[nodiscard]] std::string next_dropped();
  void set_title(const std::string& title);
  /// Makes the window smaller if it is larger than the free area of the screen that shows most of
  /// it.
  void fit_to_screen();
  /// To that screen, or back.
  void toggle_full_screen();
  [[nodiscard]] bool full_screen() const;
  /// Binds the window's own framebuffer again.
  void bind_framebuffer();
  void present();
  /// Sets the program's icon in task bars.
  void set_icon(view::Image picture);
  /// All input in order. The caller removes what it has handled.
  [[nodiscard]] std::deque<InputEvent>& input();
  /// Whether anything has happened since the last call that may need a new picture: input,
  /// resizing, exposure.
  [[nodiscard]] bool take_redraw();
  [[nodiscard]] view::Viewpoint& viewpoint();
  void framebuffer_size(int& width, int& height) const;
  /// Scale of the screen; 1: 96 dots per inch.
  [[nodiscard]] float scale() const;
  /// GLFW's own window, for the panels over the face. This object owns it.
  [[nodiscard]] GLFWwindow* native();

 private:
  struct State;
  explicit Window(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace aucast::render
