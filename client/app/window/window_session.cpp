#include "client/app/window/window_session.h"

#include <algorithm>
#include <optional>
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
      pose_(assets.face.channels.size()),
      playback_(mapping_, options, stats, notices_, pose_),
      editor_(assets, mapping_, notices_, pose_),
      composer_(assets, mapping_, notices_),
      mirror_(options.mirror),
      lister_(net::list_streams),
      gallery_(gallery_of,
               [&assets](const PlayerOptions& shown) { return gallery_size(assets, shown); }),
      exports_(glb_of),
      settings_(assets, options, mapping_, notices_, settings_events()),
      face_(assets.face, settings_, playback_, editor_, composer_, pose_),
      files_(assets.data_folder / "streams") {
  const fs::path& file = options.playback.file;
  if (playback != nullptr) playback_.open(std::move(playback), file.filename().string(), {});
  gallery_.set_folder(whole_path("gallery"));
  if (options.shows_mirror) mirror_.apply(gui::StartMirror{options.mirror.source});
}

void WindowSession::begin_with(const gui::KeptSettings& settings, const std::string& complaint,
                               Instant now) {
  if (!complaint.empty()) notices_.say(complaint, true, now);
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
    face_.show(Shown::Playback, now);
  }
  playback_.advance(now);
  lister_.advance();
  const bool made_gallery = gallery_.view().running;
  gallery_.advance(now);
  // Who has closed its dialog would not learn of it.
  const gui::GalleryView& gallery = gallery_.view();
  if (made_gallery && !gallery.running && !gallery.open)
    notices_.say(gallery.outcome, gallery.failed, now);
  if (const auto exported = exports_.advance()) notices_.tell(*exported, now);
  if (leaving_.asks()) leaving_.look(losses());
}

void WindowSession::face_shown(Instant at, bool moved) {
  playback_.face_shown();
  if (!moved || onsets_.file().empty()) return;
  onsets_.add(at, {face_.keyframe(), playback_.reached(), face_.aus()});
}

Duration WindowSession::idle_time(Instant now) const {
  Duration time = playback_.idle_time(now);
  const auto at_most = [&](Instant next, Duration least) {
    time = std::min(time, std::max(next - now, least));
  };
  const bool moves = lister_.view().asking || mirror_.running() || makes_files();
  if (moves || face_.goes_on(now)) at_most(now, kFrameMax);
  if (!notices_.view().text.empty()) at_most(notices_.until(), kFrameMax);
  if (const auto next = editor_.next_frame_at(now)) at_most(*next, Duration::zero());
  return time;
}

// === What the panels and keys ask for.

void WindowSession::apply(const gui::GuiCommand& command, Instant now) {
  face_.look(now);
  const Overloaded carry_out{
      [&](const gui::PlaybackCommand& one) {
        if (playback_.apply(one, now)) face_.show(Shown::Playback, now);
      },
      [&](const gui::SoundCommand& one) { playback_.sound().apply(one, now); },
      [&](const gui::EditorCommand& one) {
        if (editor_.apply(one, face_.is(Shown::Editor), now)) face_.show(Shown::Editor, now);
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
      [&](const gui::CancelExport&) { exports_.cancel(); },
      [&](const gui::EndOnsets&) {
        const std::string file = onsets_.file().string();
        const auto ended = onsets_.end();
        notices_.say(ended ? gui::tr("said.onsets_ended", file) : ended.error().message, !ended,
                     now);
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
  if (!server) return notices_.say(server.error().message, true, now);
  lister_.ask(*std::move(server));
}

void WindowSession::apply_composer(const gui::ComposerCommand& command, Instant now) {
  using Next = ComposerSession::Next;
  switch (composer_.apply(command, face_.is(Shown::Composer), face_.aus(), now)) {
    case Next::Nothing:
      return;
    case Next::Show:
      return face_.show(Shown::Composer, now);
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
  face_.show(Shown::Playback, now);
  if (composer_.begun()) notices_.say(gui::tr("said.not_added"), false, now);
}

/// Shows the face that was just saved to, also at the next start. It is read anew because the
/// user's copy may have other changes than the one just made.
void WindowSession::show_saved_face(Instant now) {
  const std::string saved = editor_.take_saved_face();
  if (saved.empty() || saved == faces_.view().shown) return;
  if (const auto shown = show_face(saved, now); !shown)
    notices_.say(shown.error().message, true, now);
}

/// Replaces the face. What plays goes on, and what is edited or composed stays.
Result<void> WindowSession::show_face(const fs::path& folder, Instant now) {
  const auto before = faces_.show(folder);
  if (!before) return before.error();
  mapping_.recordings = assets_.face.recordings;
  face_.change_face(*before, now);
  return {};
}

void WindowSession::toggle_pause(Instant now) {
  if (playback_.stands()) return apply(gui::Resume{}, now);
  apply(gui::Pause{}, now);
}

void WindowSession::undo(Instant now) {
  if (face_.is(Shown::Editor)) apply(gui::Undo{}, now);
  if (face_.is(Shown::Composer)) apply(gui::UndoComposing{}, now);
}

void WindowSession::redo(Instant now) {
  if (face_.is(Shown::Editor)) apply(gui::Redo{}, now);
  if (face_.is(Shown::Composer)) apply(gui::RedoComposing{}, now);
}

void WindowSession::save(Instant now) {
  if (face_.is(Shown::Editor) && editor_.au()) apply(gui::SaveAu{*editor_.au()}, now);
  if (face_.is(Shown::Composer)) apply(gui::SaveComposition{}, now);
}

/// A stream without a file opens the dialog.
void WindowSession::save_all(Instant now) {
  if (editor_.unsaved() && editor_.au()) {
    apply(gui::SaveAu{*editor_.au()}, now);
    if (editor_.unsaved()) return;  // why is said
  }
  if (composer_.unsaved()) apply(gui::SaveComposition{}, now);
}

/// Whether a gallery or a GLB file is being made in the background.
bool WindowSession::makes_files() const {
  return gallery_.view().running || !exports_.view().file.empty();
}

Losses WindowSession::losses() const {
  return {.unsaved = editor_.unsaved() || composer_.unsaved(),
          .unfinished = composer_.begun() || makes_files()};
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
  } else if (face_.keyframe() > 0) {
    stream = playback_.servers().settings().stream;
  }
  return {assets_.face.name, std::move(stream), face_.keyframe(),        face_.aus(),
          face_.edited(),    composer_.file(),  editor_.au().value_or(0)};
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
  std::optional<fs::path> begin;
  if (purpose == gui::Purpose::LookForFaces) begin = assets_.face_folder.parent_path();
  files_.browse(purpose, new_file_name(purpose, named()), begin);
}

/// Does what the dialog was opened for. Returns a sentence about what was saved, or an empty one.
Result<std::string> WindowSession::use(gui::Purpose purpose, const fs::path& file, Instant now) {
  switch (purpose) {
    case gui::Purpose::PlayStream:
      if (auto opened = open(file, now); !opened) return opened.error();
      break;
    case gui::Purpose::ComposeStream: {
      auto loaded = composer_.load(file);
      if (loaded) face_.show(Shown::Composer, now);
      return loaded;
    }
    case gui::Purpose::SaveStream:
      return save_composition(file);
    case gui::Purpose::ExportKeyframes:
      return ExportSession::stream(playback_.played(), file);
    case gui::Purpose::ExportTable:
      return ExportSession::table(playback_.played(), file);
    case gui::Purpose::ExportMesh:
      return ExportSession::mesh(assets_.face, face_.activations(), file);
    case gui::Purpose::ExportGlb:
      return exports_.glb(options_as_shown(), playback_.played(), named().stream, file);
    case gui::Purpose::LogOnsets:
      if (auto begun = onsets_.begin(file); !begun) return begun.error();
      return gui::tr("said.onsets_begun", file.string());
    case gui::Purpose::ExportAu:
      return editor_.export_au(file);
    case gui::Purpose::ImportAus: {
      auto imported = editor_.import_aus(file);
      if (!imported) return imported;
      face_.show(Shown::Editor, now);
      show_saved_face(now);
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
  if (!files_.refuse(why)) notices_.say(why, true, now);
}

/// Shows a face, or plays a file.
Result<void> WindowSession::open(const fs::path& file, Instant now) {
  if (gui::is_face_file(file)) return show_face(folder_of(file), now);
  const auto plays = play_file(file, files_, playback_, notices_, now);
  if (!plays) return plays.error();
  if (*plays) face_.show(Shown::Playback, now);
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

}  // namespace aucast::app
