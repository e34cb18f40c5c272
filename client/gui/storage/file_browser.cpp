#include "client/gui/storage/file_browser.h"

#include <algorithm>
#include <string_view>
#include <system_error>
#include <utility>

#include "client/face/face_folder.h"
#include "client/gui/texts/said_text.h"
#include "common/files.h"
#include "common/film_name.h"
#include "common/sound_name.h"
#include "common/text.h"

namespace aucast::gui {
namespace fs = std::filesystem;

namespace {

/// Whether a file may be what is wanted, by its ending. Tables are recognised by their content and
/// may have any ending: those that are not offered can still be typed.
bool may_open(Purpose purpose, const fs::path& file) {
  const std::string ending = file_ending(file);
  switch (purpose) {
    case Purpose::PlayStream:
      return ending == ".txt" || ending == ".csv" || ending == ".tsv" || is_face_file(file) ||
             is_sound(file);
    case Purpose::ComposeStream:
      return ending == ".txt";
    case Purpose::ImportAus:
      return ending == ".toml";
    case Purpose::CameraFilm:
      return is_film(file);
    default:
      return true;
  }
}

/// The file with the ending of its kind if it has none: without it no dialog would offer the file
/// again. One that is there already is meant as it is.
fs::path with_ending(fs::path file, Purpose purpose) {
  std::error_code ignored;
  if (!file.has_filename() || file.has_extension() || fs::exists(file, ignored)) return file;
  return file += ending_of(purpose);
}

/// Whether it is what saving has left: the version before, or a file that was not completed.
bool is_left_over(std::string_view name) {
  return name.ends_with('~') || name.find(kTemporaryMark) != std::string_view::npos;
}

/// Folders first, then files, each by name. Hidden entries, and files that cannot be what is
/// wanted, are left out.
std::vector<FileEntry> entries_of(const fs::path& folder, Purpose purpose, std::error_code& error) {
  std::vector<FileEntry> entries;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    FileEntry entry;
    entry.name = it->path().filename().string();
    if (entry.name.starts_with('.') || is_left_over(entry.name)) continue;
    std::error_code ignored;
    entry.folder = it->is_directory(ignored);
    const bool offered = it->is_regular_file(ignored) && may_open(purpose, it->path());
    if (entry.folder || offered) entries.push_back(std::move(entry));
  }
  std::sort(entries.begin(), entries.end(), [](const FileEntry& a, const FileEntry& b) {
    return a.folder != b.folder ? a.folder : a.name < b.name;
  });
  return entries;
}

}  // namespace

bool is_face_file(const fs::path& file) {
  return file.filename() == face::kFaceFile;
}

void FileBrowser::open(Purpose purpose, const fs::path& folder, std::string name) {
  view_ = {};
  view_.open = true;
  view_.purpose = purpose;
  view_.name = std::move(name);
  std::error_code ignored;
  fs::path shown = fs::absolute(folder, ignored);
  while (shown.has_relative_path() && !fs::is_directory(shown, ignored)) {
    shown = shown.parent_path();
  }
  view_.folder = shown.string();
  enter(shown);
}

void FileBrowser::enter(const fs::path& folder) {
  const fs::path wanted = (fs::path(view_.folder) / folder).lexically_normal();
  std::error_code error;
  std::vector<FileEntry> entries = entries_of(wanted, view_.purpose, error);
  view_.replaces.clear();
  if (error) {
    view_.problem = in_used_language(wanted.string() + ": " + error.message());
    return;
  }
  view_.problem.clear();
  view_.entries = std::move(entries);
  const bool trailing = !wanted.has_filename() && wanted.has_relative_path();
  view_.folder = (trailing ? wanted.parent_path() : wanted).string();
}

bool FileBrowser::choose(const fs::path& file, fs::path& chosen) {
  fs::path wanted = (fs::path(view_.folder) / file).lexically_normal();
  std::error_code ignored;
  if (is_folder(view_.purpose) && (file == "." || fs::is_regular_file(wanted, ignored))) {
    chosen = file == "." ? fs::path(view_.folder) : wanted.parent_path();
    return true;
  }
  if (fs::is_directory(wanted, ignored)) {
    enter(wanted);
    return false;
  }
  wanted = with_ending(std::move(wanted), view_.purpose);
  if (is_saving(view_.purpose) && view_.replaces != wanted && fs::exists(wanted, ignored)) {
    view_.replaces = wanted.string();
    view_.name = fs::path(file).replace_filename(wanted.filename()).string();
    return false;
  }
  chosen = wanted;
  return true;
}

void FileBrowser::refuse(std::string problem) {
  view_.problem = std::move(problem);
  view_.replaces.clear();
}

}  // namespace aucast::gui
