#include "client/app/window/window_session.h"

#include <algorithm>
#include <system_error>
#include <utility>
#include <variant>

#include "client/app/film/glb_export.h"
#include "client/app/gallery/gallery_command.h"
#include "client/app/steady.h"
#include "client/app/stream_files.h"
#include "client/app/window/language_choice.h"
#include "client/app/window/window_style.h"
#include "client/gui/said_text.h"
#include "client/gui/texts.h"
#include "client/gui/user_face.h"
#include "client/gui/view_text.h"
#include "client/net/stream_list.h"
#include "common/files.h"
#include "common/film_name.h"
#include "common/log.h"
#include "common/overloaded.h"
#include "protocol/codec.h"

namespace aucast::app {
namespace {

bool shows_something(const view::Layers& layers) {
  return std::any_of(view::kLayerNames.begin(), view::kLayerNames.end(),
                     [&](const view::LayerName& layer) { return layers.*layer.member; });
}

Result<std::string> gallery_of(const PlayerOptions& options, BackgroundWork::Course& course) {
  return make_gallery(
      options, [&course] { return course.cancelled(); },
      [&course](std::size_t drawn, std::size_t total) { course.reached(drawn, total); });
}

/// With a face of its own, because the window's may become another one meanwhile.
Result<std::string> glb_of(const PlayerOptions& options,
                           const std::vector<playback::Keyframe>& keyframes,
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
      animation_{options.face.mixer, options.face.rules, options.playback.interpolation},
      face_(assets.face.channels.size()),
      activations_(face_.size()),
      playback_(mapping_, options, stats, notices_, face_),
      editor_(assets, mapping_, notices_, face_),
      composer_(assets, mapping_),
      mirror_(options.mirror),
      lister_(net::list_streams),
      idle_(assets.face),
      gallery_(gallery_of,
               [&assets](const PlayerOptions& shown) { return gallery_size(assets, shown); }),
      export_(glb_of),
      files_(assets.data_folder / "streams") {
  rendering_.blinking = options.playback.blink.has_value();
  rendering_.blink = options.playback.blink.value_or(playback::BlinkOptions{});
  rendering_.layers = options.output.layers;
  const std::filesystem::path& file = options.playback.file;
  if (!file.empty()) files_.opened(file);
  std::error_code ignored;
  const std::filesystem::path sample = assets.data_folder / "streams" / "talk.txt";
  if (std::filesystem::exists(sample, ignored)) sample_ = sample.string();
  if (playback != nullptr) playback_.open(std::move(playback), file.filename().string(), {});
  gallery_.set_folder(whole_path("gallery"));
  if (options.shows_mirror) mirror_.apply(gui::StartMirror{options.mirror.source});
}

void WindowSession::begin_with(const gui::KeptSettings& settings, const std::string& complaint,
                               Instant now) {
  if (!complaint.empty()) say(complaint, true, now);
  playback_.servers().set(settings.remote, settings.recent);
  editor_.set_transition(settings.transition);
  faces_.remember(settings.face);
  files_.set_recent(settings.recent_files);
  const std::filesystem::path& file = options_.playback.file;
  if (!file.empty()) files_.opened(file);
  rendering_ = settings.rendering;
  change_pictures(settings.pictures);
  tables_.known = std::make_shared<const std::vector<gui::KnownTable>>(settings.tables);
  change_display(settings.display, now);
  display_.languages = languages_in(assets_.data_folder);
  // Nobody wants to begin with an empty view.
  if (!shows_something(rendering_.layers)) rendering_.layers = {};
}

gui::KeptSettings WindowSession::kept() const {
  gui::KeptSettings kept;
  kept.remote = playback_.servers().to_keep();
  kept.recent = playback_.servers().recent();
  kept.face = faces_.next();
  kept.recent_files = files_.recent();
  if (tables_.known != nullptr) kept.tables = *tables_.known;
  kept.animation = animation_;
  kept.transition = editor_.transition();
  kept.rendering = rendering_;
  kept.pictures = pictures_;
  // A name that is half typed would be refused at the next start.
  if (!gui::picture_name(pictures_.pattern, {}, 1)) {
    kept.pictures.pattern = gui::PictureSettings().pattern;
  }
  kept.display = display_.settings;
  return kept;
}

void WindowSession::set_sound(std::unique_ptr<sound::SoundOut> out, Instant now) {
  playback_.sound().set_out(std::move(out));
  playback_.play_beside(options_.playback.file, now);
}

// === The face.

void WindowSession::advance(Instant now) {
  notices_.expire(now);
  if (const auto own = mirror_.advance()) {
    playback_.watch_own(*own, now);
    show(Shown::Playback);
  }
  playback_.advance(now);
  lister_.advance();
  gallery_.advance();
  if (const auto exported = export_.advance()) {
    say(gui::in_used_language(*exported ? **exported : exported->error().message), !*exported, now);
  }
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
  activations_ = face_;
  pipeline::IdleOptions idle{options_.playback.idle_seed, std::nullopt};
  if (rendering_.blinking) idle.blink = rendering_.blink;
  idle_->apply(idle, seconds(now.time_since_epoch()), activations_);
  return activations_;
}

void WindowSession::face_shown(Instant at, bool moved) {
  playback_.face_shown();
  if (moved && !onsets_.file().empty()) onsets_.add(at, keyframe_shown(), aus_shown());
}

std::vector<float> WindowSession::face_of(const std::string& aus) const {
  std::vector<float> activations(mapping_.face.channels.size());
  if (const auto frame = protocol::parse_au_set(aus)) mapping_.apply(*frame, activations);
  return activations;
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

void WindowSession::show(Shown shown) {
  if (shown_ == Shown::Editor && shown != Shown::Editor) editor_.put_away();
  shown_ = shown;
}

/// What is made takes the face; what plays waits.
void WindowSession::show_edited(Shown shown, Instant now) {
  playback_.apply(gui::Pause{}, now);
  show(shown);
}

Duration WindowSession::idle_time(Instant now) const {
  Duration time = playback_.idle_time(now);
  const auto at_most = [&](Instant next, Duration least) {
    time = std::min(time, std::max(next - now, least));
  };
  if (lister_.view().asking || mirror_.running() || gallery_.view().running ||
      !export_.view().file.empty())
    at_most(now, kFrameMax);
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
        if (playback_.apply(one, now)) show(Shown::Playback);
      },
      [&](const gui::SoundCommand& one) { playback_.sound().apply(one, now); },
      [&](const gui::EditorCommand& one) {
        if (editor_.apply(one, now)) show_edited(Shown::Editor, now);
        if (gui::command_if<gui::SaveAu>(one) && !editor_.save_failed()) {
          show_saved_face(now);
        }
      },
      [&](const gui::ComposerCommand& one) { apply_composer(one, now); },
      [&](const gui::MirrorCommand& one) { mirror_.apply(one); },
      [&](const gui::GalleryCommand& one) { gallery_.apply(one, options_as_shown()); },
      [&](const gui::ChangePictures& one) { change_pictures(one.settings); },
      [&](const gui::ChangeAnimation& one) { change_animation(one.settings, now); },
      [&](const gui::ChangeRendering& one) { rendering_ = one.settings; },
      [&](const gui::ChangeDisplay& one) { change_display(one.settings, now); },
      [&](const gui::Leave& one) {
        asks_to_leave_ = false;
        leaving_ = one.really;
      },
      [&](const gui::Browse& one) { browse(one.purpose); },
      [&](const gui::EnterFolder& one) { files_.enter(one.folder); },
      [&](const gui::ChooseFile& one) {
        const std::string said =
            files_.choose(one.file, [&](gui::Purpose purpose, const std::filesystem::path& file) {
              return use_file(purpose, file, now);
            });
        if (!said.empty()) say(said, false, now);
      },
      [&](const gui::CloseBrowser&) { files_.close(); },
      [&](const gui::OpenStream& one) {
        const auto opened = open(one.file, now);
        if (opened) return files_.close();
        const std::string& why = opened.error().message;
        if (!files_.refuse(why)) say(why, true, now);
      },
      [&](const gui::ChangeTable& one) { tables_.asked = one.settings; },
      [&](const gui::ShowFace& one) {
        const auto face = show_face(one.folder, now);
        if (!face) say(face.error().message, true, now);
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
  if (std::holds_alternative<gui::ComposeShown>(command)) {
    const std::optional<AuFrame> aus = aus_shown();
    if (!aus || shown_ == Shown::Composer) return;
    composer_.take(*aus);
    show_edited(Shown::Composer, now);
  }
  if (composer_.apply(command)) show_edited(Shown::Composer, now);
  if (std::holds_alternative<gui::PlayComposition>(command)) {
    auto keyframes = composer_.keyframes();
    if (keyframes.empty()) return;
    const std::filesystem::path file = composer_.file();
    const std::string name = file.empty() ? gui::tr("said.composed") : file.filename().string();
    playback_.open(std::move(keyframes), name, now);
    show(Shown::Playback);
  }
  if (std::holds_alternative<gui::SaveComposition>(command)) {
    const std::filesystem::path file = composer_.file();
    if (file.empty()) return files_.browse(gui::Purpose::SaveStream, kComposedName);
    const auto saved = save_composition(file);
    say(saved ? *saved : saved.error().message, !saved, now);
  }
}

Result<std::string> WindowSession::save_composition(const std::filesystem::path& file) {
  auto saved = composer_.save(file);
  if (saved) files_.opened(file);
  return saved;
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

/// A gallery goes where pictures go, until the user says otherwise.
void WindowSession::change_pictures(const gui::PictureSettings& settings) {
  if (settings.folder != pictures_.folder) {
    gallery_.set_folder(whole_path(std::filesystem::path(settings.folder) / "gallery"));
  }
  pictures_ = settings;
}

/// A locale whose language there is not is no mistake of the user's.
void WindowSession::change_display(const gui::DisplaySettings& settings, Instant now) {
  display_.settings = settings;
  const bool chosen = !settings.language.empty();
  const std::string code = chosen ? settings.language : language_of_locale();
  if (code == display_.language) return;
  if (const auto used = choose_language(assets_.data_folder, code)) {
    display_.language = code;
    pace_.clear();
    composer_.change_language();
    editor_.change_language();
  } else if (chosen || used.error().kind != ErrorKind::Usage) {
    spdlog::warn("{}", used.error().message);
    say(used.error().message, true, now);
  }
}

/// What was saved is what is shown, and what the next start shows. A copy that was there may have
/// more changes than the one that was just made.
void WindowSession::show_saved_face(Instant now) {
  const std::string& saved = editor_.saved_face();
  if (saved == faces_.view().shown) return;
  if (const auto shown = show_face(saved, now); !shown) say(shown.error().message, true, now);
}

/// What plays goes on, and what is edited or composed stays.
Result<void> WindowSession::show_face(const std::filesystem::path& folder, Instant now) {
  const auto before = faces_.show(folder);
  if (!before) return before.error();
  mapping_.recordings = assets_.face.recordings;
  face_.assign(assets_.face.channels.size(), 0.0F);
  idle_.emplace(assets_.face);
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

void WindowSession::ask_to_leave() {
  // Asking twice is an answer.
  leaving_ = asks_to_leave_ || !(editor_.unsaved() || composer_.unsaved());
  asks_to_leave_ = !leaving_;
}

std::unique_ptr<playback::Playback> WindowSession::finish(Instant now) {
  return playback_.finish(now);
}

// === Files.

/// A face, or what can be played.
Result<void> WindowSession::open(const std::filesystem::path& file, Instant now) {
  return gui::is_face_file(file) ? show_face(folder_of(file), now) : play(file, now);
}

Result<void> WindowSession::play(const std::filesystem::path& file, Instant now) {
  if (is_film(file)) {
    return Error{ErrorKind::Usage, gui::tr("said.is_film", file.filename().string())};
  }
  if (!files_.view().open) tables_.asked.reset();
  const std::string name = whole_path(file).string();
  const gui::KnownTable table{name, gui::settings_for(tables_, name)};
  auto opened = open_stream(file, table.settings);
  if (!opened) return opened.error();
  notices_.clear();
  if (!opened->found.empty()) {
    gui::remember_table(tables_, table);
    const std::string changed = gui::table_in_words(table.settings);
    say(gui::in_used_language(opened->found) +
            (changed.empty() ? "" : "\n" + gui::tr("file.tables_applied", changed)),
        false, now);
  }
  files_.opened(file);
  playback_.open(std::move(opened->keyframes), file.filename().string(), now);
  playback_.play_beside(file, now);
  show(Shown::Playback);
  return {};
}

/// What plays, without an ending; empty: it has no name.
std::string WindowSession::name_of_stream() const {
  const gui::LocalView local = playback_.local_view();
  if (local.open) return std::filesystem::path(local.name).stem().string();
  return keyframe_shown() > 0 ? playback_.servers().settings().stream : std::string();
}

void WindowSession::browse(gui::Purpose purpose) {
  tables_.asked.reset();
  if (purpose == gui::Purpose::LookForFaces) {
    return files_.look_for_faces(assets_.face_folder.parent_path());
  }
  files_.browse(purpose, new_file_name(purpose, named()));
}

/// What the dialog was opened for; a sentence about what was saved.
Result<std::string> WindowSession::use_file(gui::Purpose purpose, const std::filesystem::path& file,
                                            Instant now) {
  switch (purpose) {
    case gui::Purpose::PlayStream: {
      if (auto opened = open(file, now); !opened) return opened.error();
      return std::string();
    }
    case gui::Purpose::ComposeStream: {
      if (auto loaded = composer_.load(file); !loaded) return loaded.error();
      show_edited(Shown::Composer, now);
      return std::string();
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
      return export_.glb(options_as_shown(), playback_.played(), name_of_stream(), file);
    case gui::Purpose::LogOnsets: {
      if (auto begun = onsets_.begin(file); !begun) return begun.error();
      return gui::tr("said.onsets_begun", file.string());
    }
    case gui::Purpose::ExportAu:
      return editor_.export_au(file);
    case gui::Purpose::ImportAus: {
      auto imported = editor_.import_aus(file);
      if (!imported) return imported;
      show_edited(Shown::Editor, now);
      show_saved_face(now);
      return imported;
    }
    case gui::Purpose::PictureFolder: {
      gui::PictureSettings changed = pictures_;
      changed.folder = file.string();
      change_pictures(changed);
      return std::string();
    }
    case gui::Purpose::GalleryFolder:
      gallery_.set_folder(file);
      return std::string();
    case gui::Purpose::LookForFaces:
      return look_for_faces(file, now);
    case gui::Purpose::CameraFilm:
      mirror_.set_source("camera:" + file.string());
      return std::string();
  }
  return std::string();
}

/// A folder that is a face is shown, else the faces in it are listed.
Result<std::string> WindowSession::look_for_faces(const std::filesystem::path& folder,
                                                  Instant now) {
  if (gui::is_face(folder)) {
    if (auto shown = show_face(folder, now); !shown) return shown.error();
    return std::string();
  }
  if (gui::faces_in(folder).empty()) {
    return Error{ErrorKind::BadData, gui::tr("said.no_face")};
  }
  faces_.look_in(folder);
  return std::string();
}

/// What the command line would have to say for pictures as the window's.
PlayerOptions WindowSession::options_as_shown() const {
  PlayerOptions options = options_;
  options.face = {assets_.data_folder, faces_.view().shown, animation_.rules, animation_.mixer};
  options.output.transparent |= rendering_.ground == gui::Ground::None;
  options.output.background = plain_ground(rendering_.ground, options_.output.background);
  options.output.layers = rendering_.layers;
  options.pose = {};
  return options;
}

Named WindowSession::named() const {
  return {assets_.face.name, name_of_stream(), keyframe_shown(),        aus_shown(),
          edited_shown(),    composer_.file(), editor_.au().value_or(0)};
}

Result<std::filesystem::path> WindowSession::picture_file(const std::string& ending) const {
  return new_picture_file(pictures_, named(), ending);
}

// === What the panels show.

gui::GuiModel WindowSession::model() const {
  gui::GuiModel model;
  model.remote_settings = playback_.servers().settings();
  model.recent = playback_.servers().recent();
  model.streams = lister_.view();
  model.remote = playback_.remote_view();
  model.remote.stale = model.remote.stale && shown_ == Shown::Playback;
  model.remote.eased = model.remote.eased && shown_ == Shown::Playback;
  model.local = playback_.local_view();
  model.mirror = mirror_.view();
  model.mirror.wanted = options_.shows_mirror;
  model.sound = playback_.sound().sound_view();
  model.spoken = playback_.sound().spoken_view();
  model.tables = tables_;
  model.sample = sample_;
  model.recent_files = files_.recent();
  model.faces = faces_.view();
  model.gallery = gallery_.view();
  model.pictures = pictures_;
  model.display = display_;
  model.browser = files_.view();
  model.notice = notices_.view();
  model.animation = animation_;
  model.editor = editor_.view();
  model.editor.active = shown_ == Shown::Editor;
  model.composer = composer_.view();
  model.composer.active = shown_ == Shown::Composer;
  model.composer.can_take = shown_ != Shown::Composer && aus_shown().has_value();
  model.known_aus = editor_.known_aus();
  model.video = video_;
  model.exported = export_.view();
  model.onsets = onsets_.file();
  model.expressions = editor_.expressions();
  model.transition = editor_.transition();
  model.rendering.settings = rendering_;
  model.rendering.pace = pace_;
  model.asks_to_leave = asks_to_leave_;
  return model;
}

}  // namespace aucast::app
