#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <string>

#include "client/app/face_scene.h"
#include "client/app/picture_maker.h"
#include "client/app/steady.h"
#include "client/app/window_run.h"
#include "client/pipeline/face_pipeline.h"
#include "client/playback/blinking.h"
#include "client/playback/playback_controller.h"
#include "client/render/face_renderer.h"
#include "client/render/offscreen.h"
#include "client/render/window.h"
#include "common/log.h"

namespace aucast::app {
namespace {

using playback::PlaybackState;

/// The window with everything that a frame of it needs. tick() is the table of contents.
class WindowRun {
 public:
  WindowRun(const Assets& assets, const PlayerOptions& options, playback::KeyframeSource* source,
            PlayerStats& stats)
      : assets_(assets),
        options_(options),
        source_(source),
        stats_(stats),
        scene_(assets.face),
        deformer_(assets.face),
        pipeline_(assets.face, assets.rules, {options.face.mixer, options.playback.interpolation}),
        controller_(options.playback.speed) {}

  Result<void> open() {
    auto window = render::Window::create(options_.output.width, options_.output.height, "AUcast");
    if (!window) return window.error();
    window_ = std::move(*window);
    window_->camera() = camera_preset("front", assets_.face);
    auto renderer = render::FaceRenderer::create();
    if (!renderer) return renderer.error();
    renderer_ = std::move(*renderer);
    renderer_->load(scene_.still());
    return {};
  }

  void tick(bool stopped_from_outside) {
    const Instant now = steady_now();
    window_->poll(seconds_to_wait(now));
    handle_keys();
    if (stopped_from_outside) window_->close();
    advance_playback(steady_now());
    show_state();
    draw(steady_now());
  }

  [[nodiscard]] bool done() const {
    return window_->should_close() ||
           (options_.exit_at_end && source_ != nullptr && controller_.over());
  }

  void finish() {
    if (source_ != nullptr && !controller_.over()) {
      source_->stop();
      controller_.stop(steady_now());
    }
    stats_.keyframes_played = controller_.keyframes_played();
    stats_.stalls = controller_.stalls();
    stats_.media_seconds = seconds(controller_.media_time());
  }

 private:
  /// Nothing moves: wait for an event. Something plays: the display's pace is enough.
  [[nodiscard]] double seconds_to_wait(Instant now) const {
    if (const auto next = controller_.next_position_at()) {
      return std::clamp(seconds(*next - now), 0.0, 0.02);
    }
    if (options_.playback.blink_seed) return 0.02;
    return source_ != nullptr && !controller_.over() ? 0.05 : 0.25;
  }

  void handle_keys() {
    using render::Key;
    for (Key key = window_->next_key(); key != Key::None; key = window_->next_key()) {
      switch (key) {
        case Key::Quit:
        case Key::Escape:
          window_->close();
          break;
        case Key::Space:
          toggle_pause();
          break;
        case Key::F:
          window_->toggle_full_screen();
          break;
        case Key::R:
          window_->camera() = camera_preset("front", assets_.face);
          dirty_ = true;
          break;
        case Key::S:
          save_picture();
          break;
        case Key::Question:
        case Key::None:
          break;
      }
    }
  }

  void toggle_pause() {
    const Instant now = steady_now();
    if (controller_.state() == PlaybackState::Paused) {
      controller_.resume(now);
    } else {
      controller_.pause(now);
    }
  }

  /// The picture is drawn into a framebuffer of its own, so that it does not depend on what lies
  /// over the window.
  void save_picture() {
    int width = 0;
    int height = 0;
    window_->framebuffer_size(width, height);
    auto target = render::OffscreenTarget::create(width, height);
    if (!target) {
      spdlog::error("{}", target.error().message);
      return;
    }
    (*target)->bind();
    renderer_->draw(FaceScene::moving(deformed_), window_->camera(),
                    backdrop(options_.output.background), width, height);
    const view::Image picture = (*target)->read();
    window_->bind_framebuffer();
    const std::string name = "face-player-" + std::to_string(++pictures_saved_) + ".png";
    if (const auto written = view::write_png(picture, name); !written) {
      spdlog::error("{}", written.error().message);
    } else {
      std::fprintf(stderr, "picture saved: %s\n", name.c_str());
    }
  }

  void advance_playback(Instant now) {
    if (source_ == nullptr) return;
    const std::uint64_t played = controller_.keyframes_played();
    while (const auto begun = controller_.advance(now, *source_)) {
      static_cast<void>(pipeline_.at(1.0));
      pipeline_.begin_keyframe(begun->target.aus);
      if (!first_begin_) first_begin_ = now;
    }
    if (controller_.keyframes_played() != played) {
      stats_.playback_seconds = seconds(now - *first_begin_);
    }
  }

  void show_state() {
    std::string title = "AUcast";
    if (source_ != nullptr) {
      const auto status = source_->status();
      title += " - " + std::string(playback::name(controller_.state()));
      if (!status.detail.empty()) title += ": " + status.detail;
    }
    if (title == title_) return;
    title_ = title;
    window_->set_title(title);
  }

  void draw(Instant now) {
    std::vector<float> activations = pipeline_.at(controller_.moment().mu);
    if (options_.playback.blink_seed) {
      const float closure =
          playback::blink_closure(*options_.playback.blink_seed, since_start_ms() / 1000.0);
      for (const char* lid : {"left_lid_close", "right_lid_close"}) {
        if (const auto index = assets_.face.channel_index(lid)) {
          activations[*index] = std::max(activations[*index], closure);
        }
      }
    }
    const bool redraw = window_->take_redraw() || dirty_;
    if (!redraw && activations == activations_) return;
    dirty_ = false;
    activations_ = std::move(activations);
    int width = 0;
    int height = 0;
    window_->framebuffer_size(width, height);
    if (width == 0 || height == 0) return;  // minimised
    deformer_.deform(activations_, deformed_);
    renderer_->draw(FaceScene::moving(deformed_), window_->camera(),
                    backdrop(options_.output.background), width, height);
    window_->present();
    if (stats_.frames_drawn++ == 0) stats_.first_frame_ms = since_start_ms();
    stats_.draw_seconds += seconds(steady_now() - now);
  }

  const Assets& assets_;
  const PlayerOptions& options_;
  playback::KeyframeSource* source_;
  PlayerStats& stats_;
  FaceScene scene_;
  face::FaceDeformer deformer_;
  face::DeformedFace deformed_;
  pipeline::FacePipeline pipeline_;
  playback::PlaybackController controller_;
  std::unique_ptr<render::Window> window_;
  std::unique_ptr<render::FaceRenderer> renderer_;
  std::vector<float> activations_;
  std::optional<Instant> first_begin_;
  std::string title_;
  int pictures_saved_ = 0;
  bool dirty_ = true;
};

}  // namespace

Result<void> run_window(const Assets& assets, const PlayerOptions& options,
                        playback::KeyframeSource* source, const std::function<bool()>& stop,
                        PlayerStats& stats) {
  WindowRun run(assets, options, source, stats);
  if (auto opened = run.open(); !opened) return opened;
  while (!run.done()) run.tick(stop());
  run.finish();
  return {};
}

}  // namespace aucast::app
