#include "client/app/window/files/file_session.h"

#include <system_error>
#include <utility>

#include "client/gui/storage/home_folder.h"
#include "client/gui/storage/kept_settings.h"
#include "client/gui/texts/said_text.h"
#include "common/files.h"

namespace aucast::app {

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

void FileSession::opened(const std::filesystem::path& file) {
  last_folder_ = folder_of(file);
  gui::remember_file(recent_, whole_path(file).string());
}

void FileSession::set_own_folder(const std::filesystem::path& folder) {
  std::error_code ignored;
  if (folder.empty() || !std::filesystem::is_directory(folder, ignored)) return;
  own_folder_ = saved_in_ = folder;
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
    default:
      return own_folder_;
  }
}

void FileSession::browse(gui::Purpose purpose, std::string name) {
  browser_.open(purpose, folder_for(purpose),
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

}  // namespace aucast::app
