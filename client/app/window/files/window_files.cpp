#include "client/app/window/files/window_files.h"

#include <memory>
#include <system_error>
#include <utility>
#include <variant>

#include "client/app/stream_files.h"
#include "client/gui/model/view_text.h"
#include "client/gui/storage/user_face.h"
#include "client/gui/texts/said_text.h"
#include "client/gui/texts/texts.h"
#include "common/files.h"
#include "common/film_name.h"
#include "common/overloaded.h"
#include "common/sound_name.h"

namespace aucast::app {

namespace fs = std::filesystem;

WindowFiles::WindowFiles(const Assets& assets, const fs::path& played, const Users& users,
                         Hooks hooks)
    : assets_(assets),
      played_(played),
      users_(users),
      hooks_(std::move(hooks)),
      files_(assets.data_folder / "streams") {
  if (!played_.empty()) files_.opened(played_);
  std::error_code ignored;
  const fs::path sample = assets.data_folder / "streams" / "talk.txt";
  if (fs::exists(sample, ignored)) sample_ = sample.string();
}

void WindowFiles::begin_with(const gui::KeptSettings& kept) {
  files_.set_recent(kept.recent_files);
  files_.set_own_folder(kept.own_folder);
  if (!played_.empty()) files_.opened(played_);
  tables_.known = std::make_shared<const std::vector<gui::KnownTable>>(kept.tables);
}

void WindowFiles::keep(gui::KeptSettings& kept) const {
  kept.recent_files = files_.recent();
  kept.own_folder = files_.own_folder().string();
  if (tables_.known != nullptr) kept.tables = *tables_.known;
}

void WindowFiles::apply(const gui::FileCommand& command, Instant now) {
  const Overloaded carry_out{[&](const gui::Browse& one) { browse(one.purpose); },
                             [&](const gui::EnterFolder& one) { files_.enter(one.folder); },
                             [&](const gui::ChooseFile& one) {
                               const std::string said = files_.choose(
                                   one.file, [&](gui::Purpose purpose, const fs::path& file) {
                                     return use(purpose, file, now);
                                   });
                               if (!said.empty()) users_.notices.say(said, false, now);
                             },
                             [&](const gui::CloseBrowser&) { files_.close(); },
                             [&](const gui::OpenStream& one) { open_recent(one.file, now); },
                             [&](const gui::ChangeTable& one) {
                               tables_.asked = one.settings;
                               files_.forget_problem();
                             }};
  std::visit(carry_out, command);
}

// === The dialog.

void WindowFiles::browse(gui::Purpose purpose) {
  tables_.asked.reset();
  credentials_ = {};
  if (purpose == gui::Purpose::LookForFaces) {
    return files_.look_for_faces(assets_.face_folder.parent_path());
  }
  files_.browse(purpose, new_file_name(purpose, hooks_.named()));
}

/// Does what the dialog was opened for. Returns a sentence about what was saved, or an empty one.
Result<std::string> WindowFiles::use(gui::Purpose purpose, const fs::path& file, Instant now) {
  switch (purpose) {
    case gui::Purpose::PlayStream: {
      if (auto opened = open(file, now); !opened) return opened.error();
      return std::string();
    }
    case gui::Purpose::ComposeStream: {
      const bool unsaved = users_.composer.unsaved();
      if (auto loaded = users_.composer.load(file); !loaded) return loaded.error();
      hooks_.show(Shown::Composer, now);
      return unsaved ? std::string(gui::tr("said.other_stream")) : std::string();
    }
    case gui::Purpose::SaveStream:
      return save_composition(file);
    case gui::Purpose::ExportKeyframes:
      return ExportSession::stream(users_.playback.played(), file);
    case gui::Purpose::ExportTable:
      return ExportSession::table(users_.playback.played(), file);
    case gui::Purpose::ExportMesh:
      return ExportSession::mesh(assets_.face, hooks_.activations(), file);
    case gui::Purpose::ExportGlb:
      return users_.exports.glb(hooks_.options_as_shown(), users_.playback.played(),
                                hooks_.named().stream, file);
    case gui::Purpose::LogOnsets: {
      if (auto begun = users_.onsets.begin(file); !begun) return begun.error();
      return gui::tr("said.onsets_begun", file.string());
    }
    case gui::Purpose::ExportAu:
      return users_.editor.export_au(file);
    case gui::Purpose::ImportAus:
      return import_aus(file, now);
    case gui::Purpose::PictureFolder:
      hooks_.put_pictures_in(file);
      return std::string();
    case gui::Purpose::GalleryFolder:
      users_.gallery.set_folder(file);
      return std::string();
    case gui::Purpose::LookForFaces:
      return look_for_faces(file, now);
    case gui::Purpose::AuthoritiesFile:
      credentials_.authorities = file.string();
      return std::string();
    case gui::Purpose::TokenFile:
      credentials_.token = file.string();
      return std::string();
    case gui::Purpose::CameraFilm:
      users_.mirror.set_source("camera:" + file.string());
      return std::string();
  }
  return std::string();
}

Result<std::string> WindowFiles::import_aus(const fs::path& file, Instant now) {
  auto imported = users_.editor.import_aus(file);
  if (!imported) return imported;
  hooks_.show(Shown::Editor, now);
  hooks_.show_saved_face(now);
  return imported;
}

/// Shows the face in this folder, or lists the faces in it.
Result<std::string> WindowFiles::look_for_faces(const fs::path& folder, Instant now) {
  if (gui::is_face(folder)) {
    if (auto shown = hooks_.show_face(folder, now); !shown) return shown.error();
    return std::string();
  }
  if (gui::faces_in(folder).empty()) {
    return Error{ErrorKind::BadData, gui::tr("said.no_face")};
  }
  users_.faces.look_in(folder);
  return std::string();
}

// === Streams.

void WindowFiles::open_recent(const fs::path& file, Instant now) {
  const auto opened = open(file, now);
  if (opened) return files_.close();
  const std::string why = gui::error_in_used_language(opened.error());
  if (!files_.refuse(why)) users_.notices.say(why, true, now);
}

/// Shows a face, or plays a file.
Result<void> WindowFiles::open(const fs::path& file, Instant now) {
  return gui::is_face_file(file) ? hooks_.show_face(folder_of(file), now) : play(file, now);
}

/// Plays a sound file with the stream that plays, as if it lay beside it.
Result<void> WindowFiles::play_sound(const fs::path& file, Instant now) {
  const gui::LocalView local = users_.playback.local_view();
  if (local.open) return users_.playback.sound().play_file(file, local.name, now);
  return Error{ErrorKind::Usage, gui::tr("said.sound_alone", file.filename().string())};
}

Result<void> WindowFiles::play(const fs::path& file, Instant now) {
  if (is_film(file)) {
    return Error{ErrorKind::Usage, gui::tr("said.is_film", file.filename().string())};
  }
  if (is_sound(file)) return play_sound(file, now);
  if (!files_.view().open) tables_.asked.reset();
  const std::string name = whole_path(file).string();
  const gui::KnownTable table{name, gui::settings_for(tables_, name)};
  auto opened = open_stream(file, table.settings, kDialogNames);
  if (!opened) return opened.error();
  files_.opened(file);
  users_.playback.open(std::move(opened->keyframes), file.filename().string(), now);
  if (!opened->found.empty()) {
    gui::remember_table(tables_, table);
    std::string text = gui::in_used_language(opened->found);
    const std::string changed = gui::table_in_words(table.settings);
    if (!changed.empty()) text += "\n" + gui::tr("file.tables_applied", changed);
    for (const std::string& one : opened->warnings) text += "\n" + gui::in_used_language(one);
    users_.notices.say(text, !opened->warnings.empty(), now);
  }
  users_.playback.play_beside(file, now);
  hooks_.show(Shown::Playback, now);
  return {};
}

std::string WindowFiles::name_of_stream(bool shows) const {
  const gui::LocalView local = users_.playback.local_view();
  if (local.open) return fs::path(local.name).stem().string();
  const bool begun = shows && users_.playback.keyframe() > 0;
  return begun ? users_.playback.servers().settings().stream : std::string();
}

void WindowFiles::save_composition(Instant now) {
  const fs::path file = users_.composer.file();
  if (file.empty()) return files_.browse(gui::Purpose::SaveStream, kComposedName);
  const auto saved = save_composition(file);
  users_.notices.say(saved ? *saved : saved.error().message, !saved, now);
}

Result<std::string> WindowFiles::save_composition(const fs::path& file) {
  auto saved = users_.composer.save(file);
  if (saved) files_.opened(file);
  return saved;
}

}  // namespace aucast::app
