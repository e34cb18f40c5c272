#include "client/app/window/window_display.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "client/app/steady.h"
#include "client/app/video/shot.h"
#include "client/app/window/close_nearest.h"
#include "client/app/window/thumbnails/face_thumbnails.h"
#include "client/app/window/thumbnails/keyframe_thumbnails.h"
#include "client/app/window/window_overlay.h"
#include "client/face/face_deformer.h"
#include "common/check.h"
#include "common/log.h"
#include "common/task.h"
#include "common/text.h"

namespace aucast::app {
namespace {

/// The pictures' size is too small for a face beside the panels.
constexpr int kWindowWidth = 1280;
constexpr int kWindowHeight = 800;

class GlDisplay : public WindowDisplay {
 public:
  GlDisplay(const Assets& assets, std::unique_ptr<render::Window> window,
            std::unique_ptr<FaceView> view)
      : face_(assets.face),
        window_(std::move(window)),
        view_(std::move(view)),
        face_thumbnails_(assets.data_folder, larger(gui::kFaceWidth), larger(gui::kFaceHeight)),
        overlay_(*window_) {
    window_->viewpoint() = usual_;
    if (auto icon = view::read_png(assets.data_folder / "icons" / "aucast.png")) {
      window_->set_icon(std::move(*icon));
    }
  }

  void poll(Duration wait_max) override { window_->poll(wait_max, steady_now); }

  bool take_closing() override {
    const bool closing = window_->should_close();
    if (closing) window_->keep_open();
    return closing;
  }

  std::string next_dropped() override { return window_->next_dropped(); }
  render::Key next_key() override { return overlay_.next_key(); }
  bool input_waits() const override { return overlay_.input_waits(); }

  bool take_redraw(Instant now) override {
    const bool curtain = overlay_.move_curtain(now);
    return window_->take_redraw() || curtain;
  }
  std::optional<Instant> redraws_at(Instant now) const override {
    return overlay_.curtain_falls_at(now);
  }

  void set_title(const std::string& title) override { window_->set_title(title); }

  void look_from(view::ViewpointPreset preset) override {
    window_->viewpoint() = viewpoint_of(preset, face_);
  }

  void act(WindowAct act, Instant now) override {
    switch (act) {
      case WindowAct::ToggleFullScreen:
        return toggle_full_screen(now);
      case WindowAct::ToggleBare:
        return overlay_.gui().toggle_bare();
      case WindowAct::TogglePanel:
        return overlay_.gui().toggle_panel();
      case WindowAct::ToggleKeys:
        return overlay_.gui().toggle_keys();
      case WindowAct::Leave:
      case WindowAct::CloseNearest:
        return;
    }
  }

  gui::GuiCommands close_nearest(const gui::GuiModel& shown, Instant now) override {
    Escaped escaped = app::close_nearest(overlay_.gui(), shown, window_->full_screen());
    if (escaped.ends_full_screen) toggle_full_screen(now);
    return std::move(escaped.commands);
  }

  Result<void> change_face() override {
    auto view = FaceView::create(face_);
    if (!view) return view.error();
    view_ = std::move(*view);
    pose_.clear();
    keyframe_thumbnails_.forget(overlay_.gui().keyframes());
    const view::Viewpoint before =
        std::exchange(usual_, viewpoint_of(view::ViewpointPreset::Front, face_));
    view::Viewpoint& viewpoint = window_->viewpoint();
    viewpoint.target += usual_.target - before.target;
    viewpoint.half_height *= usual_.half_height / before.half_height;
    return {};
  }

  bool make_thumbnails(const FaceOf& face_of) override {
    const bool face = face_thumbnails_.advance(overlay_.gui().faces());
    // A view that has not been posed yet, as of a face that was just dropped, has no pose to go
    // back to.
    const bool keyframe =
        !pose_.empty() && keyframe_thumbnails_.advance(overlay_.gui().keyframes(), face_of, face_,
                                                       *view_, thumbnail_scale());
    if (keyframe) view_->pose(pose_, hair_);
    if (face || keyframe) window_->bind_framebuffer();
    return face || keyframe;
  }
  bool thumbnails_wait() const override { return face_thumbnails_.busy(); }

  FrameTimes draw(const std::vector<float>& activations, const face::HairSway& hair, bool moved,
                  const view::Style& style, const gui::GuiModel& model,
                  gui::GuiCommands& commands) override {
    int width = 0;
    int height = 0;
    free_size(width, height);
    const Instant before = steady_now();
    if (moved) {
      pose_ = activations;
      hair_ = hair;
      view_->pose(pose_, hair_);
    }
    const Instant deformed = steady_now();
    renew_shaders();
    view_->draw(window_->viewpoint(), style, width, height);
    const Instant drawn = steady_now();
    if (std::exchange(listed_, model.faces.entries) != model.faces.entries && listed_ != nullptr) {
      face_thumbnails_.keep_listed(*listed_, overlay_.gui().faces());
    }
    overlay_.draw(model, commands);
    window_->present();
    return {{}, deformed - before, drawn - deformed, steady_now() - drawn};
  }

  Result<view::Image> picture(int width, int height, Sharpness sharpness,
                              const view::Style& style) override {
    if (auto prepared = view_->prepare(width, height, sharpness); !prepared) {
      return prepared.error();
    }
    view::Image image = view_->picture(window_->viewpoint(), style);
    window_->bind_framebuffer();
    return image;
  }

  void free_size(int& width, int& height) const override {
    window_->framebuffer_size(width, height);
    width = overlay_.free_width(width);
  }
  void whole_size(int& width, int& height) const override {
    window_->framebuffer_size(width, height);
  }
  bool full_screen() const override { return window_->full_screen(); }
  float scale() const override { return window_->scale(); }

 private:
  [[nodiscard]] float thumbnail_scale() const { return 2 * window_->scale(); }
  [[nodiscard]] int larger(int size) const {
    return static_cast<int>(static_cast<float>(size) * thumbnail_scale());
  }

  /// Logs what the compiler says of shaders that are being worked on, line by line.
  void renew_shaders() {
    const auto renewed = view_->renew_shaders();
    if (renewed) return;
    for (const std::string_view line : split(renewed.error().message, '\n')) {
      if (!line.empty()) spdlog::warn("{}", line);
    }
  }

  void toggle_full_screen(Instant now) {
    window_->toggle_full_screen();
    overlay_.set_full_screen(window_->full_screen(), now);
  }

  const face::Face& face_;
  std::unique_ptr<render::Window> window_;
  std::unique_ptr<FaceView> view_;
  FaceThumbnails face_thumbnails_;
  KeyframeThumbnails keyframe_thumbnails_;
  WindowOverlay overlay_;
  /// The default viewpoint of the face.
  view::Viewpoint usual_ = viewpoint_of(view::ViewpointPreset::Front, face_);
  std::shared_ptr<const std::vector<gui::FaceEntry>> listed_;
  std::vector<float> pose_;  ///< of view_; empty: not posed yet
  face::HairSway hair_;      ///< likewise
};

}  // namespace

Result<std::unique_ptr<WindowDisplay>> open_display(const Assets& assets,
                                                    const OutputOptions& output,
                                                    StartTimes& start_times) {
  // The window waits for the display most of the time that it takes to open.
  Task<face::FaceDeformer> making;
  auto started = making.start([&face = assets.face] { return face::FaceDeformer(face); });
  if (!started) return started.error();
  const bool given = output.size_given;
  auto window = render::Window::create(given ? output.width : kWindowWidth,
                                       given ? output.height : kWindowHeight, "AUcast");
  if (!window) return window.error();
  if (!given) (*window)->fit_to_screen();
  start_times.passed("window and OpenGL");
  making.wait();
  auto deformer = making.take();
  AUCAST_CHECK(deformer.has_value());
  auto view = FaceView::create(assets.face, *std::move(deformer));
  if (!view) return view.error();
  start_times.passed("face in OpenGL");
  std::unique_ptr<WindowDisplay> display =
      std::make_unique<GlDisplay>(assets, *std::move(window), *std::move(view));
  start_times.passed("panels");
  return display;
}

}  // namespace aucast::app
