#include "client/app/window/window_run.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "client/app/film/face_view.h"
#include "client/app/film/picture_notes.h"
#include "client/app/film/shot.h"
#include "client/app/start_times.h"
#include "client/app/steady.h"
#include "client/app/window/face_thumbnails.h"
#include "client/app/window/onset_log.h"
#include "client/app/window/session_video.h"
#include "client/app/window/window_overlay.h"
#include "client/app/window/window_session.h"
#include "client/app/window/window_style.h"
#include "client/gui/panels.h"
#include "client/gui/redraw.h"
#include "client/render/window.h"
#include "common/log.h"
#include "common/text.h"

namespace aucast::app {
namespace {

constexpr int kFramesPerPace = 20;
constexpr Milliseconds kSeekStep{5'000};
/// Percent, as mpv has it.
constexpr int kVolumeStep = 2;
/// The pictures' size is too small for a face beside the panels.
constexpr int kWindowWidth = 1280;
constexpr int kWindowHeight = 800;

const char* name_of(gui::View view) {
  switch (view) {
    case gui::View::Front:
      return "front";
    case gui::View::ThreeQuarter:
      return "three-quarter";
    case gui::View::Profile:
      return "profile";
  }
  return "front";
}

/// How long the stages of a frame took.
struct FrameTimes {
  Duration mix{};  ///< AUs to activations, in between frames
  Duration deform{};
  Duration face{};    ///< handing the face to OpenGL
  Duration panels{};  ///< panels, and waiting until all is on the screen
};

/// The window with everything that a frame of it needs. tick() is the table of contents.
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
    // What there is shows that something could be heard.
    if (!heard) session_.apply(gui::SoundCommand(gui::ListDevices{}), steady_now());
    session_.begin_with(settings.in_force(), settings.complaint(), steady_now());
    kept_addresses_ = session_.recent();
    start_times_.passed("session");
  }

  Result<void> open() {
    const OutputOptions& output = options_.output;
    auto window =
        render::Window::create(output.size_given ? output.width : kWindowWidth,
                               output.size_given ? output.height : kWindowHeight, "AUcast");
    if (!window) return window.error();
    window_ = std::move(*window);
    start_times_.passed("window and OpenGL");
    look_from(gui::View::Front);
    auto view = FaceView::create(assets_.face);
    if (!view) return view.error();
    view_ = std::move(*view);
    start_times_.passed("face in OpenGL");
    overlay_ = std::make_unique<WindowOverlay>(*window_);
    const auto larger = [this](int size) {
      return static_cast<int>(static_cast<float>(2 * size) * window_->scale());
    };
    thumbnails_ = std::make_unique<FaceThumbnails>(
        assets_.data_folder, larger(gui::kThumbnailWidth), larger(gui::kThumbnailHeight));
    if (auto icon = view::read_png(assets_.data_folder / "icons" / "aucast.png")) {
      window_->set_icon(std::move(*icon));
    }
    start_times_.passed("panels");
    if (output.onsets.empty()) return {};
    auto onsets = OnsetLog::create(output.onsets);
    if (!onsets) return onsets.error();
    onsets_ = std::move(*onsets);
    return {};
  }

  void tick(bool stopped_from_outside) {
    Duration idle = session_.idle_time(steady_now());
    if (const auto falls = overlay_->curtain_falls_at(steady_now())) {
      idle = std::min(idle, *falls - steady_now());
    }
    if (video_)
      idle = std::min<Duration>(idle, std::chrono::milliseconds(1000 / SessionVideo::kFps));
    if (thumbnails_->busy()) idle = std::min<Duration>(idle, kFrameMax);
    window_->poll(waits_for_frames() ? 0 : seconds(idle));
    handle_closing(stopped_from_outside);
    handle_drops();
    if (failed_) return;
    session_.advance(steady_now());
    keep_addresses();
    show_title();
    make_thumbnails();
    draw();
    record();
    handle_keys();
    for (const gui::GuiCommand& command : commands_) carry_out(command);
    commands_.clear();
  }

  [[nodiscard]] bool done() const {
    return failed_ || leaving_ || session_.leaving() || (options_.exit_at_end && session_.over());
  }

  /// Why it cannot go on, or what became of the table of onsets, which is kept either way.
  [[nodiscard]] Result<void> outcome() {
    if (failed_) return *failed_;
    return onsets_ ? onsets_->finish() : Result<void>();
  }

  [[nodiscard]] std::unique_ptr<playback::Playback> finish() {
    keep_settings();
    if (video_) end_video();
    return session_.finish(steady_now());
  }

 private:
  [[nodiscard]] bool waits_for_frames() const { return frames_due_ > 0; }

  void handle_keys() {
    using render::Key;
    for (Key key = overlay_->next_key(); key != Key::None; key = overlay_->next_key()) {
      frames_due_ = gui::kFramesAfterChange;
      switch (key) {
        case Key::Escape:
          close_what_is_open();
          break;
        case Key::Quit:
          session_.ask_to_leave();
          break;
        case Key::Space:
          session_.toggle_pause(steady_now());
          break;
        case Key::F:
          toggle_full_screen();
          break;
        case Key::H:
          overlay_->gui().toggle_bare();
          break;
        case Key::R:
          look_from(gui::View::Front);
          break;
        case Key::S:
          save_picture();
          break;
        case Key::Tab:
          overlay_->gui().toggle_panel();
          break;
        case Key::Question:
          overlay_->gui().toggle_keys();
          break;
        default:
          stream_key(key);
          break;
      }
    }
  }

  /// One thing at a time, the nearest to the user first; only q and the window's cross leave.
  void close_what_is_open() {
    if (overlay_->gui().close_keys()) return;
    if (!shown_model_.notice.text.empty()) return carry_out(gui::CloseNotice{});
    if (shown_model_.gallery.open) return carry_out(gui::GalleryCommand(gui::CloseGallery{}));
    if (window_->full_screen()) toggle_full_screen();
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

  /// Keys of a stream that is there whole, as mpv has them.
  void stream_key(render::Key key) {
    using render::Key;
    switch (key) {
      case Key::Left:
        return carry_out(gui::SeekBy{-kSeekStep});
      case Key::Right:
        return carry_out(gui::SeekBy{kSeekStep});
      case Key::Home:
        return carry_out(gui::Seek{Duration::zero()});
      case Key::End:
        return carry_out(gui::Seek{Duration::max()});
      case Key::PageUp:
        return carry_out(gui::StepKeyframe{-1});
      case Key::PageDown:
        return carry_out(gui::StepKeyframe{1});
      case Key::Comma:
        return carry_out(gui::StepFrame{-1});
      case Key::Period:
        return carry_out(gui::StepFrame{1});
      case Key::Slower:
        return carry_out(gui::ChangeSpeed{-1});
      case Key::Faster:
        return carry_out(gui::ChangeSpeed{1});
      case Key::L:
        return carry_out(gui::MarkLoop{});
      case Key::Repeat:
        return carry_out(gui::ToggleRepeat{});
      case Key::O:
        return carry_out(gui::Browse{gui::Purpose::PlayStream});
      case Key::V:
        return toggle_video();
      case Key::C:
        return carry_out(gui::SoundCommand(gui::ToggleCaptions{}));
      case Key::Mute:
        return session_.toggle_mute(steady_now());
      case Key::Quieter:
        return session_.change_volume(-kVolumeStep, steady_now());
      case Key::Louder:
        return session_.change_volume(kVolumeStep, steady_now());
      case Key::Undo:
        return session_.undo(steady_now());
      case Key::Redo:
        return session_.redo(steady_now());
      case Key::Save:
        return session_.save(steady_now());
      default:
        return;
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
    const view::Camera usual = camera_preset(name_of(gui::View::Front), assets_.face);
    const std::uint64_t faces = session_.face_changes();
    session_.apply(command, steady_now());
    if (session_.face_changes() != faces) show_new_face(usual);
  }

  /// The face of the assets is another one; it is looked at as the one before was, whose usual
  /// camera is `usual`.
  void show_new_face(const view::Camera& usual) {
    auto view = FaceView::create(assets_.face);
    if (!view) {
      failed_ = view.error();
      return;
    }
    view_ = std::move(*view);
    shown_activations_.clear();
    view::Camera& camera = window_->camera();
    const view::Camera now = camera_preset(name_of(gui::View::Front), assets_.face);
    camera.target += now.target - usual.target;
    camera.half_height *= now.half_height / usual.half_height;
  }

  void make_thumbnails() {
    gui::Gui& gui = overlay_->gui();
    const std::vector<std::string> wanted = gui.wanted_faces();
    if (!thumbnails_->advance(wanted)) return;
    for (const std::string& folder : wanted) {
      if (const auto texture = thumbnails_->texture(folder)) gui.set_face_texture(folder, texture);
    }
    window_->bind_framebuffer();
    frames_due_ = gui::kFramesAfterChange;
  }

  /// An address is worth remembering even if the machine goes down.
  void keep_addresses() {
    if (session_.recent() == kept_addresses_) return;
    kept_addresses_ = session_.recent();
    keep_settings();
  }

  void keep_settings() {
    if (const auto kept = settings_.keep(session_.kept()); !kept) {
      spdlog::warn("settings: {}", kept.error().message);
    }
  }

  void look_from(gui::View view) {
    window_->camera() = camera_preset(name_of(view), assets_.face);
    frames_due_ = gui::kFramesAfterChange;
  }

  /// Drawn into a framebuffer of its own, so that it does not depend on what lies over the window.
  Result<view::Image> picture(int width, int height, Sharpness sharpness) {
    if (auto prepared = view_->prepare(width, height, sharpness); !prepared) {
      return prepared.error();
    }
    view::Image image = view_->picture(window_->camera(), style());
    window_->bind_framebuffer();
    return image;
  }

  /// Of pictures and videos: as it is set, else the part of the window that the panel leaves free.
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
    const auto texts = texts_of({assets_.face,
                                 session_.aus_shown(),
                                 animation.rules,
                                 animation.mixer,
                                 style().layers,
                                 {},
                                 shown_activations_});
    if (const auto written = view::write_png(*image, *file, texts); !written) {
      return complain(written.error());
    }
    tell("picture saved: " + std::filesystem::absolute(*file).lexically_normal().string());
  }

  void toggle_video() {
    if (video_) return end_video();
    int width = 0;
    int height = 0;
    picture_size(width, height);
    const auto file = session_.picture_file(".mp4");
    if (!file) return complain(file.error());
    auto video = SessionVideo::open(*file, width, height, steady_now());
    if (!video) return complain(video.error());
    video_ = std::move(*video);
    session_.set_recording(video_->file().filename().string());
    session_.set_sound_tap([this](Instant heard_at, std::span<const float> samples) {
      video_->hear(heard_at, samples);
    });
  }

  void end_video() {
    session_.set_sound_tap({});
    const std::unique_ptr<SessionVideo> video = std::move(video_);
    session_.set_recording({});
    const auto finished = video->finish();
    if (!finished) return complain(finished.error());
    tell(*finished);
  }

  void record() {
    if (!video_ || !video_->due(steady_now())) return;
    const auto image = picture(video_->width(), video_->height(), Sharpness::Film);
    const auto shown = image ? video_->show(*image, steady_now()) : Result<void>(image.error());
    if (shown) return;
    session_.set_sound_tap({});
    video_.reset();
    session_.set_recording({});
    complain(shown.error());
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

  /// Draws when something is different from what is shown.
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
    view_->draw(window_->camera(), style(), overlay_->free_width(width), height);
    const Instant drawn = steady_now();
    overlay_->draw(model, commands_);
    shown_model_ = std::move(model);
    if (overlay_->input_waits()) frames_due_ = gui::kFramesAfterChange;
    window_->present();
    const Instant end = steady_now();
    session_.face_shown();
    if (moved && onsets_) onsets_->add(end, session_.keyframe_shown(), session_.aus_shown());
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
    if (moved) measure_pace(times);
  }

  [[nodiscard]] view::Style style() {
    view::Style style =
        window_style(session_.rendering(), options_.output.background, window_->scale());
    style.background.transparent |= options_.output.transparent;
    return style;
  }

  /// Only frames in which the face moved count, or showing the pace would be a reason to draw.
  void measure_pace(const FrameTimes& times) {
    pace_.mix += times.mix;
    pace_.deform += times.deform;
    pace_.face += times.face;
    pace_.panels += times.panels;
    if (++pace_frames_ < kFramesPerPace) return;
    const Instant end = steady_now();
    const auto each = [this](Duration time) {
      std::array<char, 40> text{};
      std::snprintf(text.data(), text.size(), "%.1f ms", seconds(time) * 1000 / pace_frames_);
      return std::string(text.data());
    };
    std::array<char, 40> rate{};
    std::snprintf(rate.data(), rate.size(), "%.0f", pace_frames_ / seconds(end - pace_begin_));
    session_.set_pace({{"Frames a second", rate.data()},
                       {"Activations", each(pace_.mix)},
                       {"Deforming", each(pace_.deform)},
                       {"Face", each(pace_.face)},
                       {"Panels", each(pace_.panels)}});
    pace_frames_ = 0;
    pace_begin_ = end;
    pace_ = {};
  }

  StartTimes start_times_;
  Assets& assets_;
  const PlayerOptions& options_;
  WindowSettings& settings_;
  PlayerStats& stats_;
  WindowSession session_;
  std::unique_ptr<render::Window> window_;
  std::unique_ptr<FaceView> view_;
  std::unique_ptr<FaceThumbnails> thumbnails_;
  std::unique_ptr<WindowOverlay> overlay_;
  std::vector<float> shown_activations_;
  gui::GuiModel shown_model_;
  gui::GuiCommands commands_;
  std::string title_;
  std::vector<std::string> kept_addresses_;
  int frames_due_ = gui::kFramesAfterChange;
  std::unique_ptr<SessionVideo> video_;
  std::unique_ptr<OnsetLog> onsets_;
  bool leaving_ = false;
  std::optional<Error> failed_;  ///< it cannot go on
  int pace_frames_ = 0;
  Instant pace_begin_{steady_now()};
  FrameTimes pace_;
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
