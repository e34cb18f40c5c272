#include "client/app/window/window_session.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <utility>
#include <variant>

#include "client/app/steady.h"
#include "client/app/window/composition_file.h"
#include "client/gui/user_face.h"
#include "client/net/stream_list.h"
#include "common/log.h"
#include "common/overloaded.h"

namespace aucast::app {
namespace {

constexpr const char* kComposedName = "composed.txt";
constexpr const char* kExportedName = "exported.txt";

std::string whole_path(const std::filesystem::path& file) {
  return std::filesystem::absolute(file).lexically_normal().string();
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

bool shows_something(const view::Layers& layers) {
  return std::any_of(view::kLayerNames.begin(), view::kLayerNames.end(),
                     [&](const view::LayerName& layer) { return layers.*layer.member; });
}

}  // namespace

WindowSession::WindowSession(const Assets& assets, const PlayerOptions& options,
                             std::unique_ptr<playback::Playback> playback, PlayerStats& stats)
    : assets_(assets),
      options_(options),
      mapping_(au_mapping(assets, options.face.mixer)),
      animation_{options.face.mixer, options.face.rules, options.playback.interpolation},
      face_(assets.face.channels.size()),
      activations_(face_.size()),
      playback_(mapping_, options, stats, notices_, face_),
      editor_(assets, mapping_, notices_, face_),
      composer_(assets, mapping_),
      mirror_(options.mirror),
      lister_(net::list_streams),
      idle_(assets.face),
      last_folder_(assets.data_folder / "streams") {
  rendering_.blinking = options.playback.blink.has_value();
  rendering_.blink = options.playback.blink.value_or(playback::BlinkOptions{});
  rendering_.layers = options.output.layers;
  const std::filesystem::path& file = options.playback.file;
  if (!file.empty()) last_folder_ = folder_of(file);
  std::error_code ignored;
  const std::filesystem::path sample = assets.data_folder / "streams" / "talk.txt";
  if (std::filesystem::exists(sample, ignored)) sample_ = sample.string();
  list_faces();
  if (playback != nullptr) playback_.open(std::move(playback), file.filename().string(), {});
  if (options.mirrors) mirror_.apply(gui::StartMirror{options.mirror.source});
}

void WindowSession::begin_with(const gui::KeptSettings& settings, const std::string& complaint,
                               Instant now) {
  if (!complaint.empty()) say(complaint, true, now);
  playback_.set_remote(settings.remote, settings.recent);
  editor_.set_transition(settings.transition);
  face_to_begin_with_ = settings.face;
  recent_files_ = settings.recent_files;
  const std::filesystem::path& file = options_.playback.file;
  if (!file.empty()) gui::remember_file(recent_files_, whole_path(file));
  rendering_ = settings.rendering;
  // Nobody wants to begin with an empty view.
  if (!shows_something(rendering_.layers)) rendering_.layers = {};
}

gui::KeptSettings WindowSession::kept() const {
  return {playback_.remote_settings(),
          playback_.recent(),
          face_to_begin_with_,
          recent_files_,
          animation_,
          editor_.transition(),
          rendering_};
}

void WindowSession::set_sound(std::unique_ptr<sound::SoundOut> out, Instant now) {
  playback_.set_sound(std::move(out));
  playback_.play_beside(options_.playback.file, now);
}

// === The face.

void WindowSession::advance(Instant now) {
  notices_.expire(now);
  if (const auto own = mirror_.advance()) {
    playback_.watch_own(*own, now);
    shown_ = Shown::Playback;
  }
  playback_.advance(now);
  lister_.advance();
}

/// Brings face_ to `now`.
void WindowSession::look(Instant now) {
  switch (shown_) {
    case Shown::Playback:
      face_ = playback_.activations(now);
      break;
    case Shown::Editor:
      face_ = editor_.activations(now);
      break;
    case Shown::Composer:
      face_ = composer_.activations(now);
      break;
  }
}

const std::vector<float>& WindowSession::activations(Instant now) {
  look(now);
  activations_ = face_;
  pipeline::IdleOptions idle{options_.playback.idle_seed, std::nullopt};
  if (rendering_.blinking) idle.blink = rendering_.blink;
  idle_.apply(idle, seconds(now.time_since_epoch()), activations_);
  return activations_;
}

std::optional<AuFrame> WindowSession::aus_shown() const {
  switch (shown_) {
    case Shown::Playback:
      return playback_.aus();
    case Shown::Editor:
      return editor_.aus();
    case Shown::Composer:
      break;
  }
  return face::blend(mapping_.rules, composer_.aus());
}

/// What is made takes the face; what plays waits.
void WindowSession::show_edited(Shown shown, Instant now) {
  playback_.apply(gui::Pause{}, now);
  shown_ = shown;
}

Duration WindowSession::idle_time(Instant now) const {
  Duration time = playback_.idle_time(now);
  const auto at_most = [&](Instant next, Duration least) {
    time = std::min(time, std::max(next - now, least));
  };
  if (lister_.view().asking || mirror_.running()) at_most(now, kFrameMax);
  if (!notices_.view().text.empty()) at_most(notices_.until(), kFrameMax);
  if (const auto next = editor_.next_frame_at(now)) at_most(*next, Duration::zero());
  if (rendering_.blinking || options_.playback.idle_seed)
    time = std::min<Duration>(time, kFrameMax);
  return time;
}

// === What the panels and keys ask for.

void WindowSession::apply(const gui::GuiCommand& command, Instant now) {
  look(now);
  const Overloaded carry_out{
      [&](const gui::PlaybackCommand& one) {
        if (playback_.apply(one, now)) shown_ = Shown::Playback;
      },
      [&](const gui::SoundCommand& one) { playback_.apply(one, now); },
      [&](const gui::EditorCommand& one) {
        if (editor_.apply(one, now)) show_edited(Shown::Editor, now);
        if (gui::command_if<gui::SaveAu>(one) && !editor_.view().save_failed) {
          face_to_begin_with_ = editor_.saved_face();
          list_faces();
        }
      },
      [&](const gui::ComposerCommand& one) { apply_composer(one, now); },
      [&](const gui::MirrorCommand& one) { mirror_.apply(one); },
      [&](const gui::ChangeAnimation& one) { change_animation(one.settings, now); },
      [&](const gui::ChangeRendering& one) { rendering_ = one.settings; },
      [&](const gui::Leave& one) {
        asks_to_leave_ = false;
        leaving_ = one.really;
      },
      [&](const gui::Browse& one) { browse(one.purpose); },
      [&](const gui::EnterFolder& one) { browser_.enter(one.folder); },
      [&](const gui::ChooseFile& one) { choose_file(one.file, now); },
      [&](const gui::CloseBrowser&) { browser_.close(); },
      [&](const gui::OpenStream& one) {
        const std::filesystem::path file = one.file;
        if (file.filename() == "face.toml") {
          face_to_begin_with_ = whole_path(folder_of(file));
          return say("from the next start on the face is " + face_to_begin_with_, false, now);
        }
        const auto played = play(one.file, now);
        if (played) return browser_.close();
        if (browser_.view().open) return browser_.refuse(played.error().message);
        say(played.error().message, true, now);
      },
      [&](const gui::ChangeTable& one) { table_ = one.settings; },
      [&](const gui::BeginWithFace& one) { face_to_begin_with_ = one.folder; },
      [&](const gui::CloseNotice&) { notices_.clear(); },
      [&](const gui::AskStreams& one) { ask_streams(one.settings, now); },
      [](const gui::LookFrom&) {},
      [](const gui::TakePicture&) {},
      [](const gui::ToggleVideo&) {}};
  std::visit(carry_out, command);
}

void WindowSession::ask_streams(const gui::RemoteSettings& settings, Instant now) {
  if (gui::problem(settings)) return;
  auto server = playback_.server_of(settings);
  if (!server) return say(server.error().message, true, now);
  lister_.ask(*std::move(server));
}

void WindowSession::apply_composer(const gui::ComposerCommand& command, Instant now) {
  if (std::holds_alternative<gui::ComposeShown>(command)) {
    const std::optional<AuFrame> aus = aus_shown();
    if (!aus || shown_ == Shown::Composer) return;
    composer_.take(*aus);
    show_edited(Shown::Composer, now);
  }
  if (composer_.apply(command, now)) show_edited(Shown::Composer, now);
  if (std::holds_alternative<gui::PlayComposition>(command)) {
    auto keyframes = composer_.keyframes();
    if (keyframes.empty()) return;
    const std::filesystem::path file = composer_.file();
    const std::string name = file.empty() ? "composed stream" : file.filename().string();
    playback_.open(std::move(keyframes), name, now);
    shown_ = Shown::Playback;
  }
  if (std::holds_alternative<gui::SaveComposition>(command)) {
    const std::filesystem::path file = composer_.file();
    if (file.empty()) return browser_.open(gui::Purpose::SaveStream, own_folder_, kComposedName);
    const auto saved = composer_.save(file);
    say(saved ? *saved : saved.error().message, !saved, now);
  }
}

void WindowSession::change_animation(const gui::AnimationSettings& settings, Instant now) {
  if (settings.rules != animation_.rules) {
    auto rules = face::find_rules(settings.rules, assets_.data_folder);
    if (!rules) {
      spdlog::error("{}", rules.error().message);
      return say(rules.error().message, true, now);
    }
    mapping_.rules = std::move(*rules);
  }
  animation_ = settings;
  mapping_.mixer = settings.mixer;
  playback_.remake(settings.interpolation);
  composer_.remake();
}

void WindowSession::toggle_pause(Instant now) {
  if (playback_.stands()) {
    apply(gui::Resume{}, now);
  } else {
    apply(gui::Pause{}, now);
  }
}

void WindowSession::undo(Instant now) {
  if (shown_ == Shown::Editor) apply(gui::Undo{}, now);
  if (shown_ == Shown::Composer) apply(gui::UndoComposing{}, now);
}

void WindowSession::redo(Instant now) {
  if (shown_ == Shown::Editor) apply(gui::Redo{}, now);
  if (shown_ == Shown::Composer) apply(gui::RedoComposing{}, now);
}

void WindowSession::save(Instant now) {
  if (shown_ == Shown::Editor && editor_.au()) apply(gui::SaveAu{*editor_.au()}, now);
  if (shown_ == Shown::Composer) apply(gui::SaveComposition{}, now);
}

void WindowSession::ask_to_leave() {
  // Asking twice is an answer.
  leaving_ = asks_to_leave_ || !(editor_.unsaved() || composer_.unsaved());
  asks_to_leave_ = !leaving_;
}

std::unique_ptr<playback::Playback> WindowSession::finish(Instant now) {
  return playback_.finish(now);
}

// === Files.

Result<void> WindowSession::play(const std::filesystem::path& file, Instant now) {
  auto opened = open_stream(file, table_);
  if (!opened) return opened.error();
  notices_.clear();
  if (!opened->found.empty()) say(opened->found, false, now);
  last_folder_ = folder_of(file);
  gui::remember_file(recent_files_, whole_path(file));
  playback_.open(std::move(opened->keyframes), file.filename().string(), now);
  playback_.play_beside(file, now);
  shown_ = Shown::Playback;
  return {};
}

void WindowSession::list_faces() {
  std::vector<gui::FaceEntry> faces = gui::faces_in(assets_.data_folder / "faces");
  if (const auto own = gui::user_faces_folder(std::getenv("XDG_DATA_HOME"), std::getenv("HOME"))) {
    for (gui::FaceEntry& face : gui::faces_in(*own)) {
      face.name += " (yours)";
      faces.push_back(std::move(face));
    }
  }
  faces_ = std::make_shared<const std::vector<gui::FaceEntry>>(std::move(faces));
}

void WindowSession::browse(gui::Purpose purpose) {
  if (!gui::is_saving(purpose)) return browser_.open(purpose, last_folder_);
  const bool exports = purpose == gui::Purpose::ExportKeyframes;
  browser_.open(purpose, own_folder_,
                exports ? std::string(kExportedName) : composer_.file().filename().string());
}

void WindowSession::choose_file(const std::string& name, Instant now) {
  std::filesystem::path file;
  if (!browser_.view().open || !browser_.choose(name, file)) return;
  const bool saving = gui::is_saving(browser_.view().purpose);
  const Result<std::string> used = use_file(file, now);
  if (!used) return browser_.refuse(used.error().message);
  browser_.close();
  (saving ? own_folder_ : last_folder_) = folder_of(file);
  if (saving) say(*used, false, now);
}

/// What the dialog was opened for; a sentence about what was saved.
Result<std::string> WindowSession::use_file(const std::filesystem::path& file, Instant now) {
  switch (browser_.view().purpose) {
    case gui::Purpose::PlayStream: {
      if (auto played = play(file, now); !played) return played.error();
      return std::string();
    }
    case gui::Purpose::ComposeStream: {
      if (auto loaded = composer_.load(file); !loaded) return loaded.error();
      show_edited(Shown::Composer, now);
      return std::string();
    }
    case gui::Purpose::SaveStream:
      return composer_.save(file);
    case gui::Purpose::ExportKeyframes:
      return playback_.export_to(file);
  }
  return std::string();
}

// === What the panels show.

gui::GuiModel WindowSession::model() const {
  gui::GuiModel model;
  model.remote_settings = playback_.remote_settings();
  model.recent = playback_.recent();
  model.streams = lister_.view();
  model.remote = playback_.remote_view();
  model.remote.stale = model.remote.stale && shown_ == Shown::Playback;
  model.remote.eased = model.remote.eased && shown_ == Shown::Playback;
  model.local = playback_.local_view();
  model.mirror = mirror_.view();
  model.mirror.wanted = options_.mirrors;
  model.sound = playback_.sound_view();
  model.spoken = playback_.spoken_view();
  model.table = table_;
  model.sample = sample_;
  model.recent_files = recent_files_;
  model.faces = faces_;
  model.next_face = face_to_begin_with_;
  model.browser = browser_.view();
  model.notice = notices_.view();
  model.animation = animation_;
  model.editor = editor_.view();
  model.editor.active = shown_ == Shown::Editor;
  model.composer = composer_.view();
  model.composer.active = shown_ == Shown::Composer;
  model.composer.can_take = shown_ != Shown::Composer && aus_shown().has_value();
  model.known_aus = editor_.known_aus();
  model.recording = recording_;
  model.expressions = editor_.expressions();
  model.transition = editor_.transition();
  model.rendering.settings = rendering_;
  model.rendering.pace = pace_;
  model.asks_to_leave = asks_to_leave_;
  return model;
}

}  // namespace aucast::app
