#include "client/app/window/window_overlay.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "client/view/viewpoint.h"

namespace aucast::app {

namespace {

/// Rows are in their place again in the next frame; if they never came to rest, a picture would
/// never come either.
constexpr int kSettlingMax = 4;

/// Keys of playback that belong to the panels while the keyboard focus is shown.
bool is_of_focus(render::Key key) {
  using render::Key;
  return key == Key::Space || key == Key::Left || key == Key::Right || key == Key::Home ||
         key == Key::End || key == Key::PageUp || key == Key::PageDown;
}

}  // namespace

WindowOverlay::WindowOverlay(render::Window& window) : window_(window), gui_(window.scale()) {
  ImGui_ImplGlfw_InitForOpenGL(window.native(), false);  // feed() passes on the input
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

WindowOverlay::~WindowOverlay() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
}

void WindowOverlay::draw(const gui::GuiModel& model, gui::GuiCommands& commands) {
  upload_picture(model.mirror);
  gui_.expect(model);
  if (gui_.prepare(model.display)) {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
  }
  // Frames that are made only for pending input are not put on the screen, where each would take
  // the time of a picture; those in which rows have moved would flicker there.
  int moved = 0;
  do {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    feed();
    gui_.draw(model, commands);
    if (gui_.rows_moved()) ++moved;
  } while ((input_waits() || (gui_.rows_moved() && moved < kSettlingMax)) && commands.empty() &&
           keys_.empty());
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

/// Uploads the camera's newest picture if that has not been done.
void WindowOverlay::upload_picture(const gui::MirrorView& mirror) {
  if (mirror.seen == in_texture_) return;
  in_texture_ = mirror.seen;
  if (in_texture_ == nullptr) return gui_.set_camera_texture(0);
  texture_.show(in_texture_->width, in_texture_->height, in_texture_->rgb);
  gui_.set_camera_texture(texture_.id());
}

void WindowOverlay::feed() {
  std::deque<render::InputEvent>& input = window_.input();
  for (std::size_t left = pacer_.next(input, gui_.wants_keys()); left > 0; --left) {
    take(input.front());
    input.pop_front();
  }
  mouse_.hand_over();
}

void WindowOverlay::take(const render::InputEvent& event) {
  using Kind = render::InputEvent::Kind;
  GLFWwindow* const window = window_.native();
  switch (event.kind) {
    case Kind::Move:
      move_to(event);
      break;
    case Kind::Leave:
    case Kind::Button:
      mouse_.take(event);
      break;
    case Kind::Scroll:
      if (!gui_.wants_pointer()) view::zoom(window_.viewpoint(), event.y);
      ImGui_ImplGlfw_ScrollCallback(window, event.x, event.y);
      break;
    case Kind::Key:
      ImGui_ImplGlfw_KeyCallback(window, event.code, event.scancode, event.action, event.modifiers);
      break;
    case Kind::Character:
      ImGui_ImplGlfw_CharCallback(window, static_cast<unsigned>(event.code));
      break;
    case Kind::Focus:
      ImGui_ImplGlfw_WindowFocusCallback(window, event.code);
      break;
  }
  const bool walks = gui_.focus_shown() && is_of_focus(event.meaning);
  if (event.meaning == render::Key::None || walks || gui_.wants_keys()) return;
  keys_.push_back(event.meaning);
}

/// A drag that began on the face turns the view with the left button and moves it with the right.
void WindowOverlay::move_to(const render::InputEvent& event) {
  const double right = event.x - mouse_.x();
  const double down = event.y - mouse_.y();
  mouse_.take(event);
  if (gui_.wants_pointer()) return;
  const int height = static_cast<int>(ImGui::GetIO().DisplaySize.y);
  if (mouse_.down(0)) {
    view::orbit(window_.viewpoint(), right, down, height);
  } else if (mouse_.down(1)) {
    view::pan(window_.viewpoint(), right, down, height);
  }
}

void WindowOverlay::set_full_screen(bool full_screen, Instant now) {
  curtain_.set_full_screen(full_screen, now);
}

bool WindowOverlay::move_curtain(Instant now) {
  using Kind = render::InputEvent::Kind;
  const auto& input = window_.input();
  const bool mouse = std::any_of(input.begin(), input.end(), [](const render::InputEvent& event) {
    return event.kind == Kind::Move || event.kind == Kind::Button || event.kind == Kind::Scroll;
  });
  if (mouse || gui_.wants_keys() || gui_.wants_pointer()) curtain_.touched(now);
  const bool hides = curtain_.hides(now);
  if (std::exchange(hidden_, hides) == hides) return false;
  gui_.set_hidden(hides);
  return true;
}

render::Key WindowOverlay::next_key() {
  if (keys_.empty()) return render::Key::None;
  const render::Key key = keys_.front();
  keys_.pop_front();
  return key;
}

bool WindowOverlay::input_waits() const {
  return !window_.input().empty();
}

int WindowOverlay::free_width(int framebuffer_width) const {
  const ImGuiIO& io = ImGui::GetIO();
  const float pixels = io.DisplayFramebufferScale.x > 0 ? io.DisplayFramebufferScale.x : 1;
  const auto covered = static_cast<int>(gui_.covered_width() * pixels);
  return std::max(1, framebuffer_width - covered);
}

}  // namespace aucast::app
