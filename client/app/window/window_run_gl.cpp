#include "client/app/window/window_run.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "client/app/film/face_view.h"
#include "client/app/film/picture_notes.h"
#include "client/app/film/shot.h"
#include "client/app/start_times.h"
#include "client/app/steady.h"
#include "client/app/window/close_nearest.h"
#include "client/app/window/pace_meter.h"
#include "client/app/window/recording/video_recorder.h"
#include "client/app/window/settings/window_style.h"
#include "client/app/window/thumbnails/face_thumbnails.h"
#include "client/app/window/thumbnails/keyframe_thumbnails.h"
#include "client/app/window/window_keys.h"
#include "client/app/window/window_overlay.h"
#include "client/app/window/window_session.h"
#include "client/gui/model/redraw.h"
#include "client/gui/texts/texts.h"
#include "client/render/window.h"
#include "common/files.h"
#include "common/log.h"
#include "common/overloaded.h"
#include "common/text.h"

namespace aucast::app {
namespace {

/// The pictures' size is too small for a face beside the panels.
constexpr int kWindowWidth = 1280;
constexpr int kWindowHeight = 800;

const char* name_of(gui::Facing view) {
  switch (view) {
    case gui::Facing::Front:
      return "front";
    case gui::Facing::ThreeQuarter:
      return "three-quarter";
    case gui::Facing::Profile:
      return "profile";
  }
  return "front";
}

/// The window with everything that a frame needs. tick() gives an overview.
class WindowRun {
 public:
  WindowRun(Assets& assets, const PlayerOptions& options,
            std::unique_ptr<playback::Playback> playback, std::unique_ptr<sound::SoundOut> out,
            WindowSettings& settings, PlayerStats& stats)
      : assets_(assets),
        options_(options),
        settings_(settings),
        stats_(stats),
        session_(assets, options, std::move(playback), stats) {
    const bool heard = out != nullptr;
    session_.set_sound(std::move(out), steady_now());
    // The list of devices shows the user that sound would be possible.
    if (!heard) session_.apply(gui::SoundCommand(gui::ListDevices{}), steady_now());
    session_.begin_with(settings.in_force(), settings.complaint(), steady_now());
    kept_addresses_ = session_.recent();
    kept_files_ = session_.recent_files();
    start_times_.passed("session");
  }

  Result<void> open() {
    const OutputOptions& output = options_.output;
    auto window =
        render::Window::create(output.size_given ? output.width : kWindowWidth,
                               output.size_given ? output.height : kWindowHeight, "AUcast");
    if (!window) return window.error();
    window_ = std::move(*window);
    if (!output.size_given) window_->fit_to_screen();
    start_times_.passed("window and OpenGL");
    look_from(gui::Facing::Front);
    auto view = FaceView::create(assets_.face);
    if (!view) return view.error();
    view_ = std::move(*view);
    start_times_.passed("face in OpenGL");
    overlay_ = std::make_unique<WindowOverlay>(*window_);
    const auto larger = [this](int size) {
      return static_cast<int>(static_cast<float>(size) * thumbnail_scale());
    };
    face_thumbnails_ = std::make_unique<FaceThumbnails>(
        assets_.data_folder, larger(gui::kFaceWidth), larger(gui::kFaceHeight));
    if (auto icon = view::read_png(assets_.data_folder / "icons" / "aucast.png")) {
      window_->set_icon(std::move(*icon));
    }
    start_times_.passed("panels");
    return output.onsets.empty() ? Result<void>() : session_.log_onsets(output.onsets);
  }

  void tick(bool stopped_from_outside) {
    Duration idle = session_.idle_time(steady_now());
    if (const auto falls = overlay_->curtain_falls_at(steady_now())) {
      idle = std::min(idle, *falls - steady_now());
    }
    if (video_.running())
      idle = std::min<Duration>(idle, std::chrono::milliseconds(1000 / SessionVideo::kFps));
    if (face_thumbnails_->busy() || video_.completing()) idle = std::min<Duration>(idle, kFrameMax);
    window_->poll(waits_for_frames() ? 0 : seconds(idle));
    handle_closing(stopped_from_outside);
    handle_drops();
    if (failed_) return;
    session_.advance(steady_now());
    keep_recent();
    show_title();
    make_thumbnails();
    draw();
    record();
    tell_of_video();
    handle_keys();
    for (const gui::GuiCommand& command : commands_) carry_out(command);
    commands_.clear();
  }

  [[nodiscard]] bool done() const {
    return failed_ || leaving_ || session_.leaving() || (options_.exit_at_end && session_.over());
  }

  /// The reason why it cannot go on, else the result of finishing the table of onsets, which is
  /// kept in both cases.
  [[nodiscard]] Result<void> outcome() {
    if (failed_) return *failed_;
    return session_.end_onsets();
  }

  [[nodiscard]] std::unique_ptr<playback::Playback> finish() {
    keep_settings();
    if (video_.running()) end_video();
    video_.wait();
    tell_of_video();
    return session_.finish(steady_now());
  }

 private:
  [[nodiscard]] bool waits_for_frames() const { return frames_due_ > 0; }

  void handle_keys() {
    for (render::Key key = overlay_->next_key(); key != render::Key::None;
         key = overlay_->next_key()) {
      frames_due_ = gui::kFramesAfterChange;
      const Overloaded carry_out_one{
          [&](const gui::GuiCommand& command) { carry_out(command); },
          [&](WindowAct act) { carry_out_act(act); },
          [&](SessionAct act) { (session_.*act)(steady_now()); },
          [&](ChangeVolume by) { session_.change_volume(by.percent, steady_now()); }};
      if (const KeyMeaning* meaning = meaning_of(key)) std::visit(carry_out_one, *meaning);
    }
  }

  void carry_out_act(WindowAct act) {
    switch (act) {
      case WindowAct::Leave:
        return session_.ask_to_leave();
      case WindowAct::CloseNearest:
        return close_what_is_open();
      case WindowAct::ToggleFullScreen:
        return toggle_full_screen();
      case WindowAct::ToggleBare:
        return overlay_->gui().toggle_bare();
      case WindowAct::TogglePanel:
        return overlay_->gui().toggle_panel();
      case WindowAct::ToggleKeys:
        return overlay_->gui().toggle_keys();
    }
  }

  void close_what_is_open() {
    const Escaped escaped = close_nearest(overlay_->gui(), shown_model_, window_->full_screen());
    for (const gui::GuiCommand& command : escaped.commands) carry_out(command);
    if (escaped.ends_full_screen) toggle_full_screen();
  }

  void toggle_full_screen() {
    window_->toggle_full_screen();
    overlay_->set_full_screen(window_->full_screen(), steady_now());
  }

  void handle_drops() {
    for (std::string file = window_->next_dropped(); !file.empty();
         file = window_->next_dropped()) {
      carry_out(gui::OpenStream{file});
    }
  }

  void handle_closing(bool stopped_from_outside) {
    leaving_ |= stopped_from_outside;
    if (!window_->should_close()) return;
    window_->keep_open();
    session_.ask_to_leave();
  }

  void carry_out(const gui::GuiCommand& command) {
    if (failed_) return;
    frames_due_ = gui::kFramesAfterChange;
    if (const auto* look = std::get_if<gui::LookFrom>(&command)) look_from(look->view);
    if (std::holds_alternative<gui::TakePicture>(command)) save_picture();
    if (std::holds_alternative<gui::ToggleVideo>(command)) toggle_video();
    const view::Viewpoint usual = viewpoint_preset(name_of(gui::Facing::Front), assets_.face);
    const std::uint64_t faces = session_.face_changes();
    session_.apply(command, steady_now());
    if (session_.face_changes() != faces) show_new_face(usual);
  }

  /// Call it when the assets have another face. It is seen as the previous one was. `usual`: the
  /// default viewpoint of the previous face.
  void show_new_face(const view::Viewpoint& usual) {
    auto view = FaceView::create(assets_.face);
    if (!view) {
      failed_ = view.error();
      return;
    }
    view_ = std::move(*view);
    shown_activations_.clear();
    keyframe_thumbnails_.forget(overlay_->gui().keyframes());
    view::Viewpoint& viewpoint = window_->viewpoint();
    const view::Viewpoint now = viewpoint_preset(name_of(gui::Facing::Front), assets_.face);
    viewpoint.target += now.target - usual.target;
    viewpoint.half_height *= now.half_height / usual.half_height;
  }

  [[nodiscard]] float thumbnail_scale() const { return 2 * window_->scale(); }

  void make_thumbnails() {
    const bool face = face_thumbnails_->advance(overlay_->gui().faces());
    // A view that has not been posed yet, as of a face that was just dropped, has no pose to go
    // back to.
    const bool keyframe =
        !shown_activations_.empty() &&
        keyframe_thumbnails_.advance(
            overlay_->gui().keyframes(), [this](const auto& aus) { return session_.face_of(aus); },
            assets_.face, *view_, thumbnail_scale());
    if (keyframe) view_->pose(shown_activations_);
    if (!face && !keyframe) return;
    window_->bind_framebuffer();
    frames_due_ = gui::kFramesAfterChange;
  }

  /// An address, a file and a face are worth remembering even if the machine goes down.
  void keep_recent() {
    const bool same_face = session_.face_changes() == kept_face_changes_;
    if (same_face && session_.recent() == kept_addresses_ &&
        session_.recent_files() == kept_files_) {
      return;
    }
    kept_face_changes_ = session_.face_changes();
    kept_addresses_ = session_.recent();
    kept_files_ = session_.recent_files();
    keep_settings();
  }

  void keep_settings() {
    if (const auto kept = settings_.keep(session_.kept()); !kept) {
      spdlog::warn("settings: {}", kept.error().message);
    }
  }

  void look_from(gui::Facing view) {
    window_->viewpoint() = viewpoint_preset(name_of(view), assets_.face);
    frames_due_ = gui::kFramesAfterChange;
  }

  /// Draws into a separate framebuffer, so that the picture does not depend on what lies over the
  /// window.
  Result<view::Image> picture(int width, int height, Sharpness sharpness) {
    if (auto prepared = view_->prepare(width, height, sharpness); !prepared) {
      return prepared.error();
    }
    view::Image image = view_->picture(window_->viewpoint(), style());
    window_->bind_framebuffer();
    return image;
  }

  /// The size of pictures and videos: that of the settings, else the part of the window that the
  /// panel leaves free.
  void picture_size(int& width, int& height) {
    window_->framebuffer_size(width, height);
    width = overlay_->free_width(width);
    const gui::PictureSettings& wanted = session_.pictures();
    if (wanted.width <= 0 || wanted.height <= 0) return;
    width = wanted.width;
    height = wanted.height;
  }

  void save_picture() {
    int width = 0;
    int height = 0;
    picture_size(width, height);
    const auto image = picture(width, height, Sharpness::Still);
    if (!image) return complain(image.error());
    const auto file = session_.picture_file(".png");
    if (!file) return complain(file.error());
    const gui::AnimationSettings& animation = shown_model_.animation;
    const std::string edited = session_.edited_shown();
    const auto texts = texts_of({assets_.face,
                                 session_.aus_shown(),
                                 animation.rules,
                                 animation.mixer,
                                 style().layers,
                                 {},
                                 shown_activations_,
                                 edited});
    if (const auto written = view::write_png(*image, *file, texts); !written) {
      return complain(written.error());
    }
    tell(gui::tr("said.picture", whole_path(*file).string()));
  }

  void toggle_video() {
    if (video_.running()) return end_video();
    int width = 0;
    int height = 0;
    picture_size(width, height);
    if (const auto begun = video_.begin(width, height, steady_now()); !begun) {
      return complain(begun.error());
    }
    if (session_.rendering().ground == gui::Ground::None) tell(gui::tr("said.video_black"));
  }

  void end_video() {
    const auto ending = video_.end();
    if (!ending) return complain(ending.error());
    tell(*ending);
  }

  void tell_of_video() {
    const auto ended = video_.ended();
    if (!ended) return;
    if (!*ended) return complain(ended->error());
    tell(**ended);
  }

  void record() {
    const auto film = [this](int width, int height) {
      return picture(width, height, Sharpness::Film);
    };
    if (const auto shown = video_.record(film, steady_now()); !shown) complain(shown.error());
  }

  void tell(const std::string& sentence) {
    std::fprintf(stderr, "%s\n", printable(sentence).c_str());
    session_.say(sentence, false, steady_now());
  }

  void complain(const Error& error) {
    spdlog::error("{}", error.message);
    session_.say(error.message, true, steady_now());
  }

  void show_title() {
    std::string title = session_.title();
    if (title == title_) return;
    title_ = std::move(title);
    window_->set_title(title_);
  }

  /// Draws if something differs from what is shown.
  void draw() {
    FrameTimes times;
    const Instant begin = steady_now();
    const std::vector<float>& activations = session_.activations(steady_now());
    times.mix = steady_now() - begin;
    gui::GuiModel model = session_.model();
    const bool moved = activations != shown_activations_;
    if (overlay_->move_curtain(steady_now())) frames_due_ = gui::kFramesAfterChange;
    if (window_->take_redraw()) frames_due_ = gui::kFramesAfterChange;
    frames_due_ = std::max(frames_due_, gui::frames_due(shown_model_, model));
    if (!moved && frames_due_ == 0) return;
    frames_due_ = std::max(0, frames_due_ - 1);
    int width = 0;
    int height = 0;
    window_->framebuffer_size(width, height);
    const Instant before = steady_now();
    if (moved) {
      shown_activations_ = activations;
      view_->pose(shown_activations_);
    }
    const Instant deformed = steady_now();
    view_->draw(window_->viewpoint(), style(), overlay_->free_width(width), height);
    const Instant drawn = steady_now();
    overlay_->draw(model, commands_);
    shown_model_ = std::move(model);
    if (overlay_->input_waits()) frames_due_ = gui::kFramesAfterChange;
    window_->present();
    const Instant end = steady_now();
    session_.face_shown(end, moved);
    spdlog::trace("drawn at {:.6f}", seconds(end.time_since_epoch()));
    if (stats_.frames_drawn++ == 0) {
      stats_.first_frame_ms = since_start_ms();
      start_times_.passed("picture");
      spdlog::debug("{}", start_times_.text());
    }
    stats_.draw_seconds += seconds(end - before);
    times.deform = deformed - before;
    times.face = drawn - deformed;
    times.panels = end - drawn;
    // Only frames in which the face moved count, or showing the pace would be a reason to draw.
    if (!moved) return;
    if (auto pace = pace_.add(times, end)) session_.set_pace(std::move(*pace));
  }

  [[nodiscard]] view::Style style() {
    view::Style style =
        window_style(session_.rendering(), options_.output.background, window_->scale());
    style.background.transparent |= options_.output.transparent;
    return style;
  }

  StartTimes start_times_;
  Assets& assets_;
  const PlayerOptions& options_;
  WindowSettings& settings_;
  PlayerStats& stats_;
  WindowSession session_;
  std::unique_ptr<render::Window> window_;
  std::unique_ptr<FaceView> view_;
  std::unique_ptr<FaceThumbnails> face_thumbnails_;
  KeyframeThumbnails keyframe_thumbnails_;
  std::unique_ptr<WindowOverlay> overlay_;
  std::vector<float> shown_activations_;
  gui::GuiModel shown_model_;
  gui::GuiCommands commands_;
  std::string title_;
  std::vector<std::string> kept_addresses_;
  std::vector<std::string> kept_files_;
  std::uint64_t kept_face_changes_ = 0;
  int frames_due_ = gui::kFramesAfterChange;
  VideoRecorder video_{
      {.new_file = [this] { return session_.picture_file(".mp4"); },
       .hear = [this](sound::SoundPlayer::Tap tap) { session_.set_sound_tap(std::move(tap)); },
       .show = [this](gui::VideoView view) { session_.set_video(std::move(view)); }}};
  bool leaving_ = false;
  std::optional<Error> failed_;  ///< it cannot go on
  PaceMeter pace_{steady_now()};
};

}  // namespace

Result<void> run_window(Assets& assets, const PlayerOptions& options,
                        std::unique_ptr<playback::Playback>& playback,
                        std::unique_ptr<sound::SoundOut> out, WindowSettings& settings,
                        const std::function<bool()>& stop, PlayerStats& stats) {
  WindowRun run(assets, options, std::move(playback), std::move(out), settings, stats);
  if (auto opened = run.open(); !opened) {
    playback = run.finish();
    return opened;
  }
  while (!run.done()) run.tick(stop());
  playback = run.finish();
  return run.outcome();
}

}  // namespace aucast::app
