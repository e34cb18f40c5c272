#include "client/app/window/window_session.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "client/app/gallery/gallery_command.h"
#include "client/app/video/glb_export.h"
#include "client/app/window/files/play_file.h"
#include "client/app/window/making/face_commands.h"
#include "client/gui/storage/user_face.h"
#include "client/gui/texts/said_text.h"
#include "client/gui/texts/texts.h"
#include "client/net/stream_list.h"
#include "common/files.h"
#include "common/overloaded.h"

namespace aucast::app {

namespace fs = std::filesystem;

namespace {

Result<std::string> gallery_of(const PlayerOptions& options, BackgroundWork::Course& course) {
  return make_gallery(
      options, [&course] { return course.cancelled(); },
      [&course](std::size_t drawn, std::size_t total) { course.reached(drawn, total); });
}

/// With its own copy of the face, because the window's may be replaced meanwhile.
Result<std::string> glb_of(const PlayerOptions& options, const playback::KeyframeList& keyframes,
                           const std::string& name, BackgroundWork::Course& course) {
  const auto assets = load_assets(options.face);
  if (!assets) return assets.error();
  if (auto fits = check_length(keyframes, options, name); !fits) return fits.error();
  return export_glb(**assets, options, {keyframes, name, {}},
                    [&course](std::size_t done, std::size_t total) {
                      course.reached(done, total);
                      return !course.cancelled();
                    });
}

}  // namespace

WindowSession::WindowSession(Assets& assets, const PlayerOptions& options,
                             std::unique_ptr<playback::Playback> playback, PlayerStats& stats)
    : assets_(assets),
      faces_(assets),
      options_(options),
      mapping_(au_mapping(assets, options.face.mixer)),
      face_(assets.face.channels.size()),
      activations_(face_.size()),
      playback_(mapping_, options, stats, notices_, face_),
      editor_(assets, mapping_, notices_, face_),
      composer_(assets, mapping_, notices_),
      mirror_(options.mirror),
      lister_(net::list_streams),
      idle_(assets.face),
      hair_(assets.face),
      gallery_(gallery_of,
               [&assets](const PlayerOptions& shown) { return gallery_size(assets, shown); }),
      export_(glb_of),
      settings_(assets, options, mapping_, notices_, settings_events()),
      files_(assets.data_folder / "streams") {
  const fs::path& file = options.playback.file;
  if (playback != nullptr) playback_.open(std::move(playback), file.filename().string(), {});
  gallery_.set_folder(whole_path("gallery"));
  if (options.shows_mirror) mirror_.apply(gui::StartMirror{options.mirror.source});
}

void WindowSession::begin_with(const gui::KeptSettings& settings, const std::string& complaint,
                               Instant now) {
  if (!complaint.empty()) say(complaint, true, now);
  playback_.servers().set(settings.remote, settings.recent);
  playback_.sound().set_volume(settings.volume);
  editor_.set_transition(settings.transition);
  faces_.remember(settings.face);
  files_.begin_with(settings);
  if (!options_.playback.file.empty()) files_.opened(options_.playback.file);
  settings_.begin_with(settings, now);
}

gui::KeptSettings WindowSession::kept() const {
  gui::KeptSettings kept;
  kept.remote = playback_.servers().to_keep();
  kept.recent = playback_.servers().recent();
  kept.volume = playback_.sound().volume();
  kept.face = faces_.next();
  kept.transition = editor_.transition();
  files_.keep(kept);
  settings_.keep(kept);
  return kept;
}

SettingsSession::Events WindowSession::settings_events() {
  return {
      .on_animation =
          [this] {
            playback_.remake(settings_.animation().interpolation);
            composer_.remake();
          },
      .on_language =
          [this] {
            composer_.change_language();
            editor_.change_language();
          },
      // A gallery goes where pictures go, until the user says otherwise.
      .on_picture_folder =
          [this](const fs::path& folder) { gallery_.set_folder(whole_path(folder / "gallery")); }};
}

void WindowSession::set_sound(std::unique_ptr<sound::SoundOut> out, Instant now) {
  playback_.sound().set_out(std::move(out));
  playback_.play_beside(options_.playback.file, now);
}

// === The face.

void WindowSession::advance(Instant now) {
  notices_.expire(now);
  if (auto own = mirror_.advance()) {
    playback_.watch_own(own->endpoint, std::move(own->token), now);
    show(Shown::Playback);
  }
  playback_.advance(now);
  lister_.advance();
  const bool made_gallery = gallery_.view().running;
  gallery_.advance(now);
  // Who has closed its dialog would not learn of it.
  const gui::GalleryView& gallery = gallery_.view();
  if (made_gallery && !gallery.running && !gallery.open) say(gallery.outcome, gallery.failed, now);
  if (const auto exported = export_.advance()) notices_.tell(*exported, now);
  if (leaving_.asks()) leaving_.look(losses());
}

/// Brings face_ to `now`.
void WindowSession::look(Instant now) {
  switch (shown_) {
    case Shown::Playback:
      face_ = playback_.activations();
      break;
    case Shown::Editor:
      face_ = editor_.activations(now);
      break;
    case Shown::Composer:
      face_ = composer_.activations();
      break;
  }
}

const std::vector<float>& WindowSession::activations(Instant now) {
  look(now);
  swing_hair(now);
  activations_ = face_;
  pipeline::IdleOptions idle{options_.playback.idle_seed, std::nullopt};
  if (rendering().blinking) idle.blink = rendering().blink;
  idle_->apply(idle, seconds(now.time_since_epoch()), activations_);
  return activations_;
}

void WindowSession::swing_hair(Instant now) {
  hair_->forget_before(now);
  if (shown_ == Shown::Playback && !playback_.stands()) {
    hair_->move(now, face_);
  } else {
    hair_->put(now, face_);
  }
  hair_sway_ = hair_->at(now);
}

void WindowSession::face_shown(Instant at, bool moved) {
  playback_.face_shown();
  if (!moved || onsets_.file().empty()) return;
  onsets_.add(at, {keyframe_shown(), playback_.reached(), aus_shown()});
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
  return composer_.aus();
}

void WindowSession::show(Shown shown) {
  if (shown_ == Shown::Editor && shown != Shown::Editor) editor_.put_away();
  shown_ = shown;
}

/// Shows the face of the editor or the composer, and pauses what plays.
void WindowSession::show_edited(Shown shown, Instant now) {
  playback_.apply(gui::Pause{}, now);
  show(shown);
}

Duration WindowSession::idle_time(Instant now) const {
  Duration time = playback_.idle_time(now);
  const auto at_most = [&](Instant next, Duration least) {
    time = std::min(time, std::max(next - now, least));
  };
  if (lister_.view().asking || mirror_.running() || makes_files()) at_most(now, kFrameMax);
  if (!notices_.view().text.empty()) at_most(notices_.until(), kFrameMax);
  if (const auto next = editor_.next_frame_at(now)) at_most(*next, Duration::zero());
  if (rendering().blinking || options_.playback.idle_seed || hair_->swings(now))
    time = std::min<Duration>(time, kFrameMax);
  return time;
}

// === What the panels and keys ask for.

void WindowSession::apply(const gui::GuiCommand& command, Instant now) {
  look(now);
  const Overloaded carry_out{
      [&](const gui::PlaybackCommand& one) {
        if (playback_.apply(one, now)) show(Shown::Playback);
      },
      [&](const gui::SoundCommand& one) { playback_.sound().apply(one, now); },
      [&](const gui::EditorCommand& one) {
        if (editor_.apply(one, shown_ == Shown::Editor, now)) show_edited(Shown::Editor, now);
        show_saved_face(now);
      },
      [&](const gui::ComposerCommand& one) { apply_composer(one, now); },
      [&](const gui::MirrorCommand& one) { mirror_.apply(one); },
      [&](const gui::GalleryCommand& one) { gallery_.apply(one, options_as_shown()); },
      [&](const gui::FileCommand& one) { apply_file(one, now); },
      [&](const gui::SettingsCommand& one) { settings_.apply(one, now); },
      [&](const gui::Leave& one) {
        if (one.saves) save_all(now);
        leaving_.answer(one, losses(), files_.view().open);
      },
      [&](const gui::FaceCommand& one) {
        const auto show = [&](const fs::path& folder) { return show_face(folder, now); };
        notices_.tell(app::carry_out(one, faces_, show), now);
      },
      [&](const gui::CloseNotice&) { notices_.clear(); },
      [&](const gui::CancelExport&) { export_.cancel(); },
      [&](const gui::EndOnsets&) {
        const std::string file = onsets_.file();
        const auto ended = onsets_.end();
        say(ended ? gui::tr("said.onsets_ended", file) : ended.error().message, !ended, now);
      },
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
  using Next = ComposerSession::Next;
  switch (composer_.apply(command, shown_ == Shown::Composer, aus_shown(), now)) {
    case Next::Nothing:
      return;
    case Next::Show:
      return show_edited(Shown::Composer, now);
    case Next::Play:
      return play_composition(now);
    case Next::Save:
      return save_composition(now);
  }
}

void WindowSession::play_composition(Instant now) {
  const fs::path file = composer_.file();
  const std::string name = file.empty() ? gui::tr("said.composed") : file.filename().string();
  playback_.open(composer_.keyframes(), name, now);
  show(Shown::Playback);
  if (composer_.begun()) say(gui::tr("said.not_added"), false, now);
}

/// Shows the face that was just saved to, also at the next start. It is read anew because the
/// user's copy may have other changes than the one just made.
void WindowSession::show_saved_face(Instant now) {
  const std::string saved = editor_.take_saved_face();
  if (saved.empty() || saved == faces_.view().shown) return;
  if (const auto shown = show_face(saved, now); !shown) say(shown.error().message, true, now);
}

/// Replaces the face. What plays goes on, and what is edited or composed stays.
Result<void> WindowSession::show_face(const fs::path& folder, Instant now) {
  const auto before = faces_.show(folder);
  if (!before) return before.error();
  mapping_.recordings = assets_.face.recordings;
  face_.assign(assets_.face.channels.size(), 0.0F);
  idle_.emplace(assets_.face);
  hair_.emplace(assets_.face);
  playback_.change_face();
  editor_.change_face(*before);
  composer_.remake();
  look(now);
  return {};
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

/// A stream without a file opens the dialog.
void WindowSession::save_all(Instant now) {
  if (editor_.unsaved() && editor_.au()) {
    apply(gui::SaveAu{*editor_.au()}, now);
    if (editor_.unsaved()) return;  // why is said
  }
  if (composer_.unsaved()) apply(gui::SaveComposition{}, now);
}

Losses WindowSession::losses() const {
  return {.unsaved = editor_.unsaved() || composer_.unsaved(),
          .unfinished = composer_.begun() || makes_files()};
}

std::unique_ptr<playback::Playback> WindowSession::finish(Instant now) {
  return playback_.finish(now);
}

/// The options with which the command line would make pictures like the window's.
PlayerOptions WindowSession::options_as_shown() const {
  PlayerOptions options = settings_.applied(options_);
  options.face.data = assets_.data_folder;
  options.face.face = faces_.view().shown;
  options.pose = {};
  return options;
}

/// A server's stream counts as nameless where another session's face is shown.
Named WindowSession::named() const {
  const gui::LocalView local = playback_.local_view();
  std::string stream;
  if (local.open) {
    stream = fs::path(local.name).stem().string();
  } else if (keyframe_shown() > 0) {
    stream = playback_.servers().settings().stream;
  }
  return {assets_.face.name, std::move(stream), keyframe_shown(),        aus_shown(),
          edited_shown(),    composer_.file(),  editor_.au().value_or(0)};
}

Result<fs::path> WindowSession::picture_file(const std::string& ending) const {
  return new_picture_file(pictures(), named(), ending);
}

// === Files.

void WindowSession::apply_file(const gui::FileCommand& command, Instant now) {
  const Overloaded carry_out{
      [&](const gui::Browse& one) { browse(one.purpose); },
      [&](const gui::EnterFolder& one) { files_.enter(one.folder); },
      [&](const gui::ChooseFile& one) {
        const auto with = [&](gui::Purpose purpose, const fs::path& file) {
          return use(purpose, file, now);
        };
        notices_.tell(files_.choose(one.file, with), now);
      },
      [&](const gui::CloseBrowser&) { files_.close(); },
      [&](const gui::OpenStream& one) { open_recent(one.file, now); },
      [&](const gui::ChangeTable& one) { files_.change_table(one.settings); }};
  std::visit(carry_out, command);
  if (!files_.view().open) leaving_.chosen(losses());
}

void WindowSession::browse(gui::Purpose purpose) {
  if (purpose == gui::Purpose::LookForFaces) {
    return files_.look_for_faces(assets_.face_folder.parent_path());
  }
  files_.browse(purpose, new_file_name(purpose, named()));
}

/// Does what the dialog was opened for. Returns a sentence about what was saved, or an empty one.
Result<std::string> WindowSession::use(gui::Purpose purpose, const fs::path& file, Instant now) {
  switch (purpose) {
    case gui::Purpose::PlayStream:
      if (auto opened = open(file, now); !opened) return opened.error();
      break;
    case gui::Purpose::ComposeStream: {
      auto loaded = composer_.load(file);
      if (loaded) show_edited(Shown::Composer, now);
      return loaded;
    }
    case gui::Purpose::SaveStream:
      return save_composition(file);
    case gui::Purpose::ExportKeyframes:
      return ExportSession::stream(playback_.played(), file);
    case gui::Purpose::ExportTable:
      return ExportSession::table(playback_.played(), file);
    case gui::Purpose::ExportMesh:
      return ExportSession::mesh(assets_.face, activations_, file);
    case gui::Purpose::ExportGlb:
      return export_.glb(options_as_shown(), playback_.played(), named().stream, file);
    case gui::Purpose::LogOnsets:
      if (auto begun = onsets_.begin(file); !begun) return begun.error();
      return gui::tr("said.onsets_begun", file.string());
    case gui::Purpose::ExportAu:
      return editor_.export_au(file);
    case gui::Purpose::ImportAus: {
      auto imported = editor_.import_aus(file);
      if (imported) show_edited(Shown::Editor, now);
      if (imported) show_saved_face(now);
      return imported;
    }
    case gui::Purpose::PictureFolder: {
      gui::PictureSettings changed = settings_.pictures();
      changed.folder = file.string();
      settings_.change_pictures(changed);
      break;
    }
    case gui::Purpose::GalleryFolder:
      gallery_.set_folder(file);
      break;
    case gui::Purpose::LookForFaces:
      return look_for_faces(file, now);
    case gui::Purpose::CameraFilm:
      mirror_.set_source("camera:" + file.string());
      break;
    case gui::Purpose::AuthoritiesFile:
    case gui::Purpose::TokenFile:
      break;  // the dialog itself remembers them
  }
  return std::string();
}

/// Shows the face in this folder, or lists the faces in it.
Result<std::string> WindowSession::look_for_faces(const fs::path& folder, Instant now) {
  if (gui::is_face(folder)) {
    if (auto shown = show_face(folder, now); !shown) return shown.error();
  } else if (gui::faces_in(folder).empty()) {
    return Error{ErrorKind::BadData, gui::tr("said.no_face")};
  } else {
    faces_.look_in(folder);
  }
  return std::string();
}

void WindowSession::open_recent(const fs::path& file, Instant now) {
  const auto opened = open(file, now);
  if (opened) return files_.close();
  const std::string why = gui::error_in_used_language(opened.error());
  if (!files_.refuse(why)) say(why, true, now);
}

/// Shows a face, or plays a file.
Result<void> WindowSession::open(const fs::path& file, Instant now) {
  if (gui::is_face_file(file)) return show_face(folder_of(file), now);
  const auto plays = play_file(file, files_, playback_, notices_, now);
  if (!plays) return plays.error();
  if (*plays) show(Shown::Playback);
  return {};
}

/// Saves the composed stream in the file that it came from, or asks the user for a file.
void WindowSession::save_composition(Instant now) {
  const fs::path file = composer_.file();
  if (file.empty()) return files_.browse(gui::Purpose::SaveStream, kComposedName);
  notices_.tell(save_composition(file), now);
}

Result<std::string> WindowSession::save_composition(const fs::path& file) {
  auto saved = composer_.save(file);
  if (saved) files_.opened(file);
  return saved;
}

// === What the panels show.

gui::GuiModel WindowSession::model() const {
  gui::GuiModel model;
  model.remote_settings = playback_.servers().settings();
  model.recent = playback_.servers().recent();
  model.streams = lister_.view();
  model.playing = playback_.playing_view();
  model.playing.stale = model.playing.stale && shown_ == Shown::Playback;
  model.playing.eased = model.playing.eased && shown_ == Shown::Playback;
  model.local = playback_.local_view();
  model.mirror = mirror_.view();
  model.mirror.wanted = options_.shows_mirror;
  model.sound = playback_.sound().sound_view();
  model.spoken = playback_.sound().spoken_view();
  model.tables = files_.tables();
  model.sample = files_.sample();
  model.recent_files = files_.recent();
  model.faces = faces_.view();
  model.gallery = gallery_.view();
  model.pictures = settings_.pictures();
  model.picture_folder = whole_path(fs::path(".") / model.pictures.folder).string();
  model.display = settings_.display();
  model.browser = files_.view();
  model.credentials = files_.credentials();
  model.notice = notices_.view();
  model.animation = settings_.animation();
  model.editor = editor_.view(shown_ == Shown::Editor);
  model.composer = composer_.view(shown_ == Shown::Composer);
  if (shown_ == Shown::Editor) model.playing.aus = editor_.au_rows();
  if (shown_ == Shown::Composer) model.playing.aus = composer_.au_rows();
  model.composer.can_take = shown_ != Shown::Composer && aus_shown().has_value();
  model.known_aus = editor_.known_aus();
  model.exported = export_.view();
  model.onsets = onsets_.file();
  model.expressions = editor_.expressions();
  model.transition = editor_.transition();
  model.rendering.settings = settings_.rendering();
  model.asks_to_leave = leaving_.asks();
  return model;
}

}  // namespace aucast::app
