#include "client/render/window.h"

// libepoxy must be first: GLFW would bring OpenGL headers of its own.
#include <epoxy/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "client/view/screen_area.h"
#include "common/text.h"

namespace aucast::render {
namespace {

constexpr int kWindowSamples = 4;
/// The most events that are kept if nobody takes them.
constexpr std::size_t kInputMax = 4096;

/// GLFW's last complaint; it has one per process, as there is one window.
std::string& last_complaint() {
  static std::string complaint;
  return complaint;
}

void remember(int, const char* description) {
  last_complaint() = escaped(description, 200);
}

std::string because() {
  return last_complaint().empty() ? std::string() : " (" + last_complaint() + ")";
}

Error no_display() {
  return {ErrorKind::Failed, "no display to open a window on" + because() +
                                 ": use --headless, with --record FILE.mp4 or --frames DIR to see "
                                 "the face"};
}

Error no_opengl() {
  return {ErrorKind::Failed,
          "this display cannot do OpenGL 3.3" + because() +
              ": install the driver of the graphics card, or Mesa, which needs none "
              "(apt install libgl1 libgl1-mesa-dri; LIBGL_ALWAYS_SOFTWARE=1 "
              "chooses it); or use --headless, with --record FILE.mp4"};
}

/// Makes the window with multisampling or, as some displays do not have that, without.
GLFWwindow* open_window(int width, int height, const std::string& title) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "face-player");  // as the .desktop file has it
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "face-player");
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);  // the size is meant at 96 dots an inch
  for (const int samples : {kWindowSamples, 0}) {
    glfwWindowHint(GLFW_SAMPLES, samples);
    GLFWwindow* window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (window != nullptr) return window;
  }
  return nullptr;
}

/// The monitor that shows most of the window; null: there is none.
GLFWmonitor* monitor_of(GLFWwindow* window) {
  int count = 0;
  GLFWmonitor** const monitors = glfwGetMonitors(&count);
  std::vector<view::ScreenArea> screens;
  for (int i = 0; i < count; ++i) {
    view::ScreenArea& screen = screens.emplace_back();
    glfwGetMonitorPos(monitors[i], &screen.x, &screen.y);
    const GLFWvidmode* const mode = glfwGetVideoMode(monitors[i]);
    if (mode != nullptr) screen.width = mode->width;
    if (mode != nullptr) screen.height = mode->height;
  }
  if (screens.empty()) return nullptr;
  view::ScreenArea own;
  glfwGetWindowPos(window, &own.x, &own.y);
  glfwGetWindowSize(window, &own.width, &own.height);
  return monitors[view::screen_of(own, screens)];
}

struct CodeKey {
  int code;
  Key key;
};

/// The key of a code; None if it has none.
Key found(std::span<const CodeKey> keys, int code) {
  const auto key = std::find_if(keys.begin(), keys.end(),
                                [code](const CodeKey& one) { return one.code == code; });
  return key == keys.end() ? Key::None : key->key;
}

constexpr auto kAlone = std::to_array<CodeKey>({{GLFW_KEY_SPACE, Key::Space},
                                                {GLFW_KEY_ESCAPE, Key::Escape},
                                                {GLFW_KEY_LEFT, Key::Left},
                                                {GLFW_KEY_RIGHT, Key::Right},
                                                {GLFW_KEY_HOME, Key::Home},
                                                {GLFW_KEY_END, Key::End},
                                                {GLFW_KEY_PAGE_UP, Key::PageUp},
                                                {GLFW_KEY_PAGE_DOWN, Key::PageDown},
                                                {GLFW_KEY_Q, Key::Quit},
                                                {GLFW_KEY_F, Key::F},
                                                {GLFW_KEY_S, Key::S},
                                                {GLFW_KEY_V, Key::V},
                                                {GLFW_KEY_C, Key::C},
                                                {GLFW_KEY_R, Key::R},
                                                {GLFW_KEY_P, Key::P},
                                                {GLFW_KEY_H, Key::H},
                                                {GLFW_KEY_L, Key::L},
                                                {GLFW_KEY_O, Key::O}});
/// With Ctrl these mean something else; any other key but C means the same.
constexpr auto kWithControl = std::to_array<CodeKey>({{GLFW_KEY_W, Key::Quit},
                                                      {GLFW_KEY_S, Key::Save},
                                                      {GLFW_KEY_Z, Key::Undo},
                                                      {GLFW_KEY_Y, Key::Redo}});

Key key_of(int code, int modifiers) {
  const bool shift = (modifiers & GLFW_MOD_SHIFT) != 0;
  if ((modifiers & GLFW_MOD_CONTROL) != 0) {
    if (code == GLFW_KEY_C) return Key::None;  // to be copied
    const Key key = found(kWithControl, code);
    if (key != Key::None) return key == Key::Undo && shift ? Key::Redo : key;
  }
  const Key key = found(kAlone, code);
  return key == Key::L && shift ? Key::Repeat : key;
}

/// Whether the command is repeated while the key is held.
bool repeats(Key key) {
  return key == Key::Left || key == Key::Right || key == Key::PageUp || key == Key::PageDown;
}

/// Whether the key types a character: its meaning then comes from the character event.
bool is_text(int code, int modifiers) {
  constexpr int kCommands = GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;
  return code >= GLFW_KEY_SPACE && code < GLFW_KEY_ESCAPE && (modifiers & kCommands) == 0;
}

Key key_of_character(unsigned character) {
  constexpr auto kCharacters = std::to_array<CodeKey>({{'?', Key::Question},
                                                       {',', Key::Comma},
                                                       {'.', Key::Period},
                                                       {'[', Key::Slower},
                                                       {']', Key::Faster},
                                                       {'m', Key::Mute},
                                                       {'9', Key::Quieter},
                                                       {'0', Key::Louder}});
  return found(kCharacters, static_cast<int>(character));
}

}  // namespace

struct Window::State {
  GLFWwindow* window = nullptr;
  view::Viewpoint viewpoint;
  std::deque<std::string> dropped;
  std::deque<InputEvent> input;
  bool redraw = true;
  Instant (*clock)() = nullptr;
  Instant looked_at{};  ///< what comes is newer
  double pointer_x = 0;
  double pointer_y = 0;
  /// Place and size before full screen.
  std::array<int, 4> windowed{};

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (window != nullptr) glfwDestroyWindow(window);
    glfwTerminate();
  }

  static State& of(GLFWwindow* window) {
    return *static_cast<State*>(glfwGetWindowUserPointer(window));
  }
  void happened(InputEvent event) {
    redraw = true;
    event.after = looked_at;
    event.by = clock == nullptr ? looked_at : clock();
    if (input.size() < kInputMax) input.push_back(event);
  }
  void listen();
  void listen_to_pointer();
};

void Window::State::listen() {
  glfwSetWindowUserPointer(window, this);
  glfwGetCursorPos(window, &pointer_x, &pointer_y);
  glfwSetKeyCallback(window, [](GLFWwindow* self, int code, int scan, int action, int modifiers) {
    Key meaning = action == GLFW_RELEASE ? Key::None : key_of(code, modifiers);
    if (action == GLFW_REPEAT && !repeats(meaning)) meaning = Key::None;
    of(self).happened({InputEvent::Kind::Key, code, scan, action, modifiers, 0, 0, meaning,
                       is_text(code, modifiers)});
  });
  // The place of these depends on the keyboard: they are taken as characters.
  glfwSetCharCallback(window, [](GLFWwindow* self, unsigned character) {
    of(self).happened({InputEvent::Kind::Character, static_cast<int>(character), 0, 0, 0, 0, 0,
                       key_of_character(character)});
  });
  glfwSetDropCallback(window, [](GLFWwindow* self, int count, const char** files) {
    of(self).redraw = true;
    for (int i = 0; i < count; ++i) of(self).dropped.emplace_back(files[i]);
  });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* self) { of(self).redraw = true; });
  glfwSetFramebufferSizeCallback(window,
                                 [](GLFWwindow* self, int, int) { of(self).redraw = true; });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* self, int focused) {
    of(self).happened({InputEvent::Kind::Focus, focused});
  });
  listen_to_pointer();
}

void Window::State::listen_to_pointer() {
  glfwSetCursorPosCallback(window, [](GLFWwindow* self, double x, double y) {
    of(self).pointer_x = x;
    of(self).pointer_y = y;
    of(self).happened({InputEvent::Kind::Move, 0, 0, 0, 0, x, y});
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* self, int code, int action, int modifiers) {
    of(self).happened({InputEvent::Kind::Button, code, 0, action, modifiers});
  });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* self, int entered) {
    const auto kind = entered == GLFW_TRUE ? InputEvent::Kind::Move : InputEvent::Kind::Leave;
    of(self).happened({kind, 0, 0, 0, 0, of(self).pointer_x, of(self).pointer_y});
  });
  glfwSetScrollCallback(window, [](GLFWwindow* self, double aside, double steps) {
    of(self).happened({InputEvent::Kind::Scroll, 0, 0, 0, 0, aside, steps});
  });
}

Window::Window(std::unique_ptr<State> state) : state_(std::move(state)) {}
Window::~Window() = default;

Result<std::unique_ptr<Window>> Window::create(int width, int height, const std::string& title) {
  last_complaint().clear();
  glfwSetErrorCallback(remember);
  if (glfwInit() != GLFW_TRUE) return no_display();
  auto state = std::make_unique<State>();
  state->window = open_window(width, height, title);
  if (state->window == nullptr) return no_opengl();
  glfwMakeContextCurrent(state->window);
  if (!epoxy_is_desktop_gl() || epoxy_gl_version() < 33) return no_opengl();
  glfwSwapInterval(1);
  state->listen();
  return std::unique_ptr<Window>(new Window(std::move(state)));
}

bool Window::should_close() const {
  return glfwWindowShouldClose(state_->window) == GLFW_TRUE;
}

void Window::keep_open() {
  glfwSetWindowShouldClose(state_->window, GLFW_FALSE);
}

void Window::poll(Duration wait_max, Instant (*clock)()) {
  State& state = *state_;
  state.clock = clock;
  const std::size_t before = state.input.size();
  const bool redraw = std::exchange(state.redraw, false);
  glfwPollEvents();
  state.looked_at = clock();
  const bool came = state.redraw || state.input.size() > before || should_close();
  if (!came && wait_max > Duration::zero()) {
    glfwWaitEventsTimeout(seconds(wait_max));
    state.looked_at = clock();
  }
  state.redraw |= redraw;
}

std::string Window::next_dropped() {
  if (state_->dropped.empty()) return {};
  std::string file = std::move(state_->dropped.front());
  state_->dropped.pop_front();
  return file;
}

void Window::set_title(const std::string& title) {
  glfwSetWindowTitle(state_->window, title.c_str());
}

bool Window::full_screen() const {
  return glfwGetWindowMonitor(state_->window) != nullptr;
}

void Window::fit_to_screen() {
  GLFWmonitor* const monitor = monitor_of(state_->window);
  if (monitor == nullptr) return;
  int room_width = 0;
  int room_height = 0;
  glfwGetMonitorWorkarea(monitor, nullptr, nullptr, &room_width, &room_height);
  int width = 0;
  int height = 0;
  glfwGetWindowSize(state_->window, &width, &height);
  if (width <= room_width && height <= room_height) return;
  glfwSetWindowSize(state_->window, std::min(width, room_width), std::min(height, room_height));
}

void Window::toggle_full_screen() {
  GLFWwindow* window = state_->window;
  auto& [x, y, width, height] = state_->windowed;
  if (full_screen()) {
    glfwSetWindowMonitor(window, nullptr, x, y, width, height, GLFW_DONT_CARE);
    return;
  }
  GLFWmonitor* monitor = monitor_of(window);
  const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
  if (mode == nullptr) return;
  glfwGetWindowPos(window, &x, &y);
  glfwGetWindowSize(window, &width, &height);
  glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void Window::bind_framebuffer() {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void Window::present() {
  glfwSwapBuffers(state_->window);
}

bool Window::take_redraw() {
  return std::exchange(state_->redraw, false);
}

view::Viewpoint& Window::viewpoint() {
  return state_->viewpoint;
}

void Window::framebuffer_size(int& width, int& height) const {
  glfwGetFramebufferSize(state_->window, &width, &height);
  // A minimised window has no pixels, and a picture has at least one.
  width = std::max(width, 1);
  height = std::max(height, 1);
}

std::deque<InputEvent>& Window::input() {
  return state_->input;
}

void Window::set_icon(view::Image picture) {
  const GLFWimage image{picture.width, picture.height, picture.rgba.data()};
  glfwSetWindowIcon(state_->window, 1, &image);
}

float Window::scale() const {
  float x = 1;
  float y = 1;
  glfwGetWindowContentScale(state_->window, &x, &y);
  return std::clamp(x, 0.5F, 4.0F);
}

GLFWwindow* Window::native() {
  return state_->window;
}

}  // namespace aucast::render
