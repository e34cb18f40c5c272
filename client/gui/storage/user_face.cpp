#include "client/gui/storage/user_face.h"

#include <algorithm>
#include <system_error>

#include "client/face/face_folder.h"
#include "common/files.h"
#include "common/text.h"
#include "common/toml_document.h"

namespace aucast::gui {
namespace {

namespace fs = std::filesystem;

Error failed(const std::string& what, const fs::path& where, const std::error_code& cause) {
  return {ErrorKind::Failed, what + " " + at_place(where.string(), cause.message())};
}

bool lies_in(const fs::path& inner, const fs::path& outer) {
  const fs::path a = fs::weakly_canonical(inner);
  const fs::path b = fs::weakly_canonical(outer);
  const auto [end_a, end_b] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return end_b == b.end();
}

/// A face may use files of another face, as the shipped people share their muscles. A copy of
/// `from` has such files in its own folder.
Result<void> make_whole(const fs::path& copy, const fs::path& from) {
  const fs::path description = copy / face::kFaceFile;
  if (!fs::exists(description)) return {};
  const auto document = read_toml(description);
  if (!document) return document.error();
  auto text = read_file(description);
  if (!text) return text.error();
  for (const char* key : {"mesh", "muscles", "aus"}) {
    const TomlValue* named = document->find(key);
    if (named == nullptr) continue;
    const fs::path file = fs::path(named->text).lexically_normal();
    if (file.is_relative() && *file.begin() != "..") continue;
    std::string name = file.filename().string();
    if (fs::exists(copy / name)) name = file.parent_path().filename().string() + "_" + name;
    fs::copy_file(from / file, copy / name);
    std::size_t line = 0;
    for (std::size_t i = 1; i < named->place.line; ++i) line = text->find('\n', line) + 1;
    const std::size_t at = text->find(named->text, line);
    if (at == std::string::npos) {
      return Error{ErrorKind::BadData,
                   at_place(description.string(), named->place.line, named->place.column,
                            "is written with escapes; write the name as it is")};
    }
    text->replace(at, named->text.size(), name);
  }
  return write_file_atomically(description, *text);
}

/// The file name that face.toml gives for its AUs.
Result<fs::path> aus_file_of(const fs::path& face_folder) {
  const fs::path description = face_folder / face::kFaceFile;
  std::error_code ignored;
  if (!fs::exists(description, ignored)) {
    return Error{ErrorKind::Failed,
                 printable(face_folder.string()) +
                     " is a classic face: its Action Units come from a table for all such faces "
                     "and cannot be saved with it"};
  }
  const auto document = read_toml(description);
  if (!document) return document.error();
  if (const TomlValue* aus = document->find("aus")) return face_folder / aus->text;
  return Error{ErrorKind::BadData, at_place(description.string(), "names no file of AUs")};
}

/// Replaces the face's AU file by what `change` makes of it.
template <typename Change>
Result<fs::path> change_aus(const fs::path& face_folder, const Change& change) {
  auto file = aus_file_of(face_folder);
  if (!file) return file.error();
  auto before = read_file(*file);
  if (!before) return before.error();
  Result<std::string> after = change(*before, file->string());
  if (!after) return after.error();
  if (*after == *before) return file;
  const fs::path previous = file->string() + "~";
  if (auto kept = write_file_atomically(previous, *before); !kept) return kept.error();
  if (auto written = write_file_atomically(*file, *after); !written) return written.error();
  return file;
}

}  // namespace

Result<fs::path> user_faces_folder(const char* xdg_data_home, const char* home) {
  const auto base = users_folder(xdg_data_home, home, ".local/share");
  if (!base) {
    return Error{ErrorKind::Failed,
                 "no place for your own faces: set HOME or XDG_DATA_HOME to a folder"};
  }
  return *base / "aucast" / "faces";
}

bool is_face(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(folder / face::kFaceFile, ignored) ||
         fs::exists(folder / "faceline.dat", ignored);
}

std::vector<FaceEntry> faces_in(const fs::path& folder) {
  std::vector<FaceEntry> faces;
  std::error_code failed;
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
    if (!is_face(at->path())) continue;
    faces.push_back({at->path().filename().string(), at->path().string(), {}});
  }
  std::sort(faces.begin(), faces.end(),
            [](const FaceEntry& a, const FaceEntry& b) { return a.name < b.name; });
  return faces;
}

Result<fs::path> writable_face(const fs::path& face_folder, const fs::path& user_faces) {
  const fs::path from = face_folder.has_filename() ? face_folder : face_folder.parent_path();
  fs::path unfinished;
  try {
    if (lies_in(from, user_faces)) return from;
    const fs::path copy = user_faces / fs::weakly_canonical(from).filename();
    if (fs::exists(copy)) return copy;
    unfinished = copy.string() + ".unfinished";
    fs::create_directories(user_faces);
    fs::remove_all(unfinished);
    fs::copy(from, unfinished, fs::copy_options::recursive);
    const Result<void> whole = make_whole(unfinished, from);
    // Shipped files may be read-only; a copy is there to be changed.
    for (const auto& entry : fs::recursive_directory_iterator(unfinished)) {
      fs::permissions(entry.path(), fs::perms::owner_write, fs::perm_options::add);
    }
    if (!whole) {
      fs::remove_all(unfinished);
      return whole.error();
    }
    fs::rename(unfinished, copy);
    return copy;
  } catch (const fs::filesystem_error& error) {
    // Half a face is of no use, and the disk may be full.
    std::error_code ignored;
    if (!unfinished.empty()) fs::remove_all(unfinished, ignored);
    return failed("this face cannot be copied to", user_faces, error.code());
  }
}

bool is_own_face(const fs::path& face_folder, const fs::path& user_faces) {
  try {
    return lies_in(face_folder, user_faces);
  } catch (const fs::filesystem_error&) {
    return false;  // a folder that cannot be looked into
  }
}

Result<fs::path> save_aus(const fs::path& face_folder, const std::vector<SavedAu>& aus) {
  return change_aus(face_folder, [&](const std::string& text, const std::string& file) {
    Result<std::string> changed = text;
    for (const SavedAu& au : aus) {
      changed = with_au(*changed, file, au.number, au.drive, au.name);
      if (!changed) break;
    }
    return changed;
  });
}

Result<fs::path> remove_au(const fs::path& face_folder, int number) {
  return change_aus(face_folder, [&](const std::string& text, const std::string& file) {
    return without_au(text, file, number);
  });
}

}  // namespace aucast::gui
