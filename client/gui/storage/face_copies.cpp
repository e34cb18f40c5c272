#include "client/gui/storage/face_copies.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <string_view>
#include <system_error>
#include <vector>

#include "client/face/face_folder.h"
#include "client/gui/model/face_names.h"
#include "client/gui/storage/toml_edit.h"
#include "client/gui/storage/user_face.h"
#include "common/files.h"
#include "common/text.h"
#include "common/toml_document.h"
#include "common/toml_writer.h"

namespace aucast::gui {
namespace {

namespace fs = std::filesystem;

Error failed(const std::string& what, const fs::path& where, const std::error_code& cause) {
  return {ErrorKind::Failed, what + " " + at_place(where.string(), cause.message())};
}

/// Whether anything has this name, also a link that leads nowhere.
bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

Error there_already(const fs::path& path) {
  return {ErrorKind::Usage, at_place(path.string(), "is there already; choose another name")};
}

fs::path without_slash(const fs::path& folder) {
  return folder.has_filename() ? folder : folder.parent_path();
}

/// Gives a key of `file`, which has this text, another text as its value, if it has the key.
Result<void> put_key(std::string& toml, const char* key, const std::string& text,
                     const fs::path& file) {
  const auto document = parse_toml(toml, file.string());
  if (!document) return document.error();
  const TomlValue* const value = document->find(key);
  return value == nullptr ? Result<void>() : put_text(toml, file.string(), *value, text);
}

/// Copies a file. Shipped ones may be read-only; a copy is there to be changed.
std::error_code copy_writable(const fs::path& from, const fs::path& to) {
  std::error_code cause;
  fs::copy_file(from, to, cause);
  if (!cause) fs::permissions(to, fs::perms::owner_write, fs::perm_options::add, cause);
  return cause;
}

/// Copies a folder and what is in it, except linked folders, which may lead round in a circle.
/// Shipped folders may be read-only, which fs::copy would make of the new ones before there is
/// anything in them.
std::error_code copy_files(const fs::path& from, const fs::path& to) {
  std::error_code cause;
  fs::create_directory(to, cause);
  if (cause) return cause;
  for (fs::directory_iterator at(from, cause), end; !cause && at != end;) {
    const fs::path copy = to / at->path().filename();
    const bool folder = at->is_directory(cause);
    if (!folder) {
      cause = copy_writable(at->path(), copy);
    } else if (!at->is_symlink()) {
      cause = copy_files(at->path(), copy);
    }
    if (!cause) at.increment(cause);
  }
  return cause;
}

Error not_copied(const fs::path& own_faces, const std::error_code& cause) {
  return failed("this face cannot be copied to", own_faces, cause);
}

/// A face may use files of another face, as the shipped people share their muscles. A copy of
/// `from` has such files in its own folder.
Result<void> make_whole(const fs::path& copy, const fs::path& from) {
  const fs::path description = copy / face::kFaceFile;
  if (!is_there(description)) return {};
  auto text = read_file(description);
  if (!text) return text.error();
  const auto document = parse_toml(*text, description.string());
  if (!document) return document.error();
  for (const char* key : {"mesh", "muscles", "aus"}) {
    const TomlValue* named = document->find(key);
    if (named == nullptr) continue;
    const fs::path file = fs::path(named->text).lexically_normal();
    if (file.empty() || (file.is_relative() && *file.begin() != "..")) continue;
    std::string name = file.filename().string();
    if (is_there(copy / name)) name = file.parent_path().filename().string() + "_" + name;
    if (const auto cause = copy_writable(from / file, copy / name)) {
      return not_copied(copy.parent_path(), cause);
    }
    if (auto put = put_key(*text, key, name, description); !put) return put;
  }
  return write_file_atomically(description, *text);
}

/// Gives a copy its name in its face.toml, where it also says of which face it is a copy. A classic
/// face has no other name than its folder's.
Result<void> name_copy(const fs::path& copy, const std::string& name, const std::string& origin) {
  const fs::path description = copy / face::kFaceFile;
  if (!is_there(description)) return {};
  auto text = read_file(description);
  if (!text) return text.error();
  if (auto put = put_key(*text, "name", name, description); !put) return put;
  const auto document = parse_toml(*text, description.string());
  if (!document) return document.error();
  const TomlValue* named = document->find("name");
  if (named != nullptr && document->find("copy_of") == nullptr) {
    std::size_t below = 0;
    for (std::size_t i = 0; i < named->place.line; ++i) below = text->find('\n', below) + 1;
    text->insert(below, toml_line("copy_of", toml_text(origin)));
  }
  return write_file_atomically(description, *text);
}

/// Keeps the AUs of a new copy as they are now, unless they are kept from an earlier copying.
Result<void> keep_original_aus(const fs::path& copy) {
  const auto document = read_toml(copy / face::kFaceFile);
  const TomlValue* aus = document ? document->find("aus") : nullptr;
  const fs::path kept = copy / kOriginalAusFile;
  if (aus == nullptr || is_there(kept)) return {};
  const auto bytes = read_file(copy / aus->text);
  if (!bytes) return bytes.error();
  return write_file_atomically(kept, *bytes);
}

/// What a copy says that it was made of: a name for a shipped face, which may lie elsewhere the
/// next time; a path for one from elsewhere, which may have the name of a shipped one.
std::string origin_for_copy(const fs::path& from, const FaceFolders& faces) {
  std::error_code ignored;
  const fs::path whole = fs::weakly_canonical(from, ignored);
  const bool shipped = fs::equivalent(whole.parent_path(), faces.shipped, ignored);
  if (shipped || is_own_face(from, faces.own)) return origin_of(from);
  return whole.string();
}

/// A copy has this name until it is complete, and behind it the number of the process.
constexpr const char* kUnfinished = ".unfinished ";
/// No copy takes this long: a program that did not complete one by then has died at it. Whether its
/// process is there would say nothing where several computers have the same home.
constexpr std::chrono::hours kInterruptedAfter{1};

/// Removes what interrupted copies have left behind.
void remove_interrupted(const fs::path& own_faces) {
  const auto now = fs::file_time_type::clock::now();
  std::error_code failed;
  std::vector<fs::path> left;
  for (fs::directory_iterator at(own_faces, failed), end; !failed && at != end;
       at.increment(failed)) {
    std::error_code vanished;
    const auto begun = at->last_write_time(vanished);
    const bool copying = at->path().filename().string().starts_with(kUnfinished);
    if (copying && !vanished && now - begun >= kInterruptedAfter) left.push_back(at->path());
  }
  for (const fs::path& copy : left) fs::remove_all(copy, failed);
}

/// Makes the copy in `unfinished`, a folder in that of the user's own faces.
Result<void> make_copy(const fs::path& from, const FaceFolders& faces, const std::string& name,
                       const fs::path& unfinished) {
  std::error_code cause;
  fs::create_directories(faces.own, cause);
  if (!cause) fs::remove_all(unfinished, cause);
  if (!cause) cause = copy_files(from, unfinished);
  if (cause) return not_copied(faces.own, cause);
  if (auto whole = make_whole(unfinished, from); !whole) return whole;
  // Pictures of it must not bear the name of the face that it was made of.
  const bool alike = name == fs::weakly_canonical(from, cause).filename();
  const std::string shown = alike ? "own_" + name : name;
  if (auto named = name_copy(unfinished, shown, origin_for_copy(from, faces)); !named) return named;
  return keep_original_aus(unfinished);
}

}  // namespace

std::string origin_of(const fs::path& face_folder) {
  const auto document = read_toml(face_folder / face::kFaceFile);
  const TomlValue* origin = document ? document->find("copy_of") : nullptr;
  if (origin != nullptr && !origin->text.empty()) return origin->text;
  std::error_code ignored;
  return fs::weakly_canonical(without_slash(face_folder), ignored).filename().string();
}

fs::path shipped_origin(const fs::path& own_face, const fs::path& shipped_faces) {
  const fs::path origin = origin_of(own_face);
  if (origin.has_parent_path() || !is_face(shipped_faces / origin)) return {};
  return shipped_faces / origin;
}

Result<fs::path> writable_face(const fs::path& face_folder, const FaceFolders& faces) {
  const fs::path from = without_slash(face_folder);
  const bool classic = is_face(from) && !is_there(from / face::kFaceFile);
  if (classic || is_own_face(from, faces.own)) return from;
  std::error_code ignored;
  std::string name = fs::weakly_canonical(from, ignored).filename().string();
  const fs::path usual = faces.own / name;
  // A link may lead to a shipped face.
  const bool may = is_there(usual) && is_own_face(usual, faces.own);
  if (may && origin_of(usual) == origin_for_copy(from, faces)) return usual;
  if (is_there(usual)) {
    name = name_for_copy(name, [&](const std::string& one) { return is_there(faces.own / one); });
  }
  return copy_face(from, faces, name);
}

Result<fs::path> copy_face(const fs::path& face_folder, const FaceFolders& faces,
                           const std::string& name) {
  const fs::path from = without_slash(face_folder);
  const fs::path copy = faces.own / name;
  if (is_there(copy)) return there_already(copy);
  remove_interrupted(faces.own);
  // Another program may be copying at the same time.
  const fs::path unfinished = faces.own / (kUnfinished + std::to_string(::getpid()));
  Result<void> made = make_copy(from, faces, name, unfinished);
  std::error_code cause;
  if (made) fs::rename(unfinished, copy, cause);
  if (cause) made = not_copied(faces.own, cause);
  if (made) return copy;
  // Half a face is of no use, and the disk may be full.
  fs::remove_all(unfinished, cause);
  return made.error();
}

Result<fs::path> rename_face(const fs::path& own_face, const std::string& name) {
  const fs::path to = own_face.parent_path() / name;
  if (is_there(to)) return there_already(to);
  const std::string origin = origin_of(own_face);
  std::error_code cause;
  fs::rename(own_face, to, cause);
  if (cause) return failed("this face cannot be renamed to", to, cause);
  if (fs::is_symlink(fs::symlink_status(to, cause))) return to;
  if (auto named = name_copy(to, name, origin); !named) {
    fs::rename(to, own_face, cause);
    return named.error();
  }
  return to;
}

Result<void> delete_face(const fs::path& own_face) {
  std::error_code cause;
  if (fs::is_symlink(fs::symlink_status(own_face, cause))) {
    fs::remove(own_face, cause);
    if (cause) return failed("this face cannot be deleted:", own_face, cause);
    return {};
  }
  // Under a hidden name first, so that no half of a face is left to choose. What could not be
  // deleted of an earlier one must not be in the way.
  fs::path aside;
  for (int number = 1; aside.empty() || is_there(aside); ++number) {
    aside = own_face.parent_path() / (".deleted " + std::to_string(number));
    fs::remove_all(aside, cause);
  }
  fs::rename(own_face, aside, cause);
  if (cause) return failed("this face cannot be deleted:", own_face, cause);
  fs::remove_all(aside, cause);
  if (cause) return failed("not all of this face could be deleted:", aside, cause);
  return {};
}

}  // namespace aucast::gui
