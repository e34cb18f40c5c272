#include "client/app/window/files/file_session.h"

#include <memory>
#include <system_error>
#include <utility>

#include "client/gui/storage/home_folder.h"
#include "client/gui/texts/said_text.h"
#include "common/files.h"

namespace aucast::app {

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

FileSession::FileSession(const std::filesystem::path& streams) : last_folder_(streams) {
  std::error_code ignored;
  const std::filesystem::path sample = streams / "talk.txt";
  if (std::filesystem::exists(sample, ignored)) sample_ = sample.string();
}

void FileSession::begin_with(const gui::KeptSettings& kept) {
  recent_ = kept.recent_files;
  tables_.known = std::make_shared<const std::vector<gui::KnownTable>>(kept.tables);
  std::error_code ignored;
  if (std::filesystem::is_directory(kept.own_folder, ignored)) {
    own_folder_ = saved_in_ = kept.own_folder;
  }
}

void FileSession::keep(gui::KeptSettings& kept) const {
  kept.recent_files = recent_;
  kept.own_folder = saved_in_.string();
  if (tables_.known != nullptr) kept.tables = *tables_.known;
}

void FileSession::opened(const std::filesystem::path& file) {
  last_folder_ = folder_of(file);
  gui::remember_file(recent_, whole_path(file).string());
}

/// The folder in which a file of this purpose was last.
std::filesystem::path& FileSession::folder_for(gui::Purpose purpose) {
  switch (purpose) {
    case gui::Purpose::PlayStream:
    case gui::Purpose::ComposeStream:
      return last_folder_;
    case gui::Purpose::AuthoritiesFile:
    case gui::Purpose::TokenFile:
      return credentials_folder_;
    case gui::Purpose::SaveStream:
    case gui::Purpose::ExportKeyframes:
    case gui::Purpose::ExportTable:
    case gui::Purpose::ExportMesh:
    case gui::Purpose::ExportGlb:
    case gui::Purpose::LogOnsets:
    case gui::Purpose::ExportAu:
    case gui::Purpose::ImportAus:
    case gui::Purpose::PictureFolder:
    case gui::Purpose::GalleryFolder:
    case gui::Purpose::LookForFaces:
    case gui::Purpose::CameraFilm:
      break;
  }
  return own_folder_;
}

void FileSession::browse(gui::Purpose purpose, std::string name,
                         const std::optional<std::filesystem::path>& folder) {
  // What was asked and chosen in the dialog before is over.
  tables_.asked.reset();
  credentials_ = {};
  browser_.open(purpose, folder.value_or(folder_for(purpose)),
                gui::is_saving(purpose) ? std::move(name) : std::string());
}

std::string FileSession::choose(const std::string& name, const Use& use) {
  std::filesystem::path file;
  const std::string path = gui::with_home(name);
  if (!browser_.view().open || !browser_.choose(path, file)) return {};
  const gui::Purpose purpose = browser_.view().purpose;
  const Result<std::string> used = use(purpose, file);
  if (!used) {
    browser_.refuse(gui::error_in_used_language(used.error()));
    return {};
  }
  browser_.close();
  if (purpose == gui::Purpose::AuthoritiesFile) credentials_.authorities = file.string();
  if (purpose == gui::Purpose::TokenFile) credentials_.token = file.string();
  // Where faces lie is no place for streams, nor for what the user exports.
  if (purpose != gui::Purpose::LookForFaces && !gui::is_face_file(file)) {
    folder_for(purpose) = gui::is_folder(purpose) ? file : folder_of(file);
    if (gui::is_saving(purpose)) saved_in_ = whole_path(folder_of(file));
  }
  return *used;
}

void FileSession::close() {
  const gui::BrowserView& view = browser_.view();
  if (view.open && view.purpose != gui::Purpose::LookForFaces) {
    folder_for(view.purpose) = view.folder;
  }
  browser_.close();
}

bool FileSession::refuse(std::string problem) {
  if (!browser_.view().open) return false;
  browser_.refuse(std::move(problem));
  return true;
}

void FileSession::change_table(const gui::TableSettings& settings) {
  tables_.asked = settings;
  browser_.forget_problem();
}

gui::KnownTable FileSession::table_of(const std::filesystem::path& file) {
  if (!browser_.view().open) tables_.asked.reset();
  const std::string name = whole_path(file).string();
  return {name, gui::settings_for(tables_, name)};
}

}  // namespace aucast::app
