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

/// The file name that face.toml gives for its AUs.
Result<fs::path> aus_file_of(const fs::path& face_folder) {
  const fs::path description = face_folder / face::kFaceFile;
  std::error_code ignored;
  if (!is_face(face_folder)) {
    return Error{ErrorKind::Failed,
                 at_place(face_folder.string(), "this face is gone; choose another one")};
  }
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
    FaceEntry face{at->path().filename().string(), at->path().string()};
    // A hidden one is a copy that is being made or deleted.
    if (face.name.starts_with('.') || !is_face(at->path())) continue;
    if (std::error_code no_link; at->is_symlink(no_link)) {
      face.target = fs::read_symlink(at->path(), no_link).string();
    }
    faces.push_back(std::move(face));
  }
  std::sort(faces.begin(), faces.end(),
            [](const FaceEntry& a, const FaceEntry& b) { return a.name < b.name; });
  return faces;
}

bool is_own_face(const fs::path& face_folder, const fs::path& user_faces) {
  std::error_code failed;
  const fs::path face = fs::weakly_canonical(face_folder, failed);
  if (failed) return false;
  const fs::path own = fs::weakly_canonical(user_faces, failed);
  if (failed) return false;
  return std::mismatch(face.begin(), face.end(), own.begin(), own.end()).second == own.end();
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
