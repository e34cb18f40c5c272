#include "client/app/window/making/face_session.h"

#include <algorithm>
#include <string>
#include <utility>

#include "client/app/window/making/own_faces.h"
#include "client/face/face.h"
#include "client/gui/model/face_names.h"
#include "client/gui/storage/face_copies.h"
#include "client/gui/storage/user_face.h"
#include "client/gui/texts/texts.h"
#include "common/files.h"
#include "common/log.h"

namespace aucast::app {
namespace {

namespace fs = std::filesystem;

/// The path of a folder in one form, so that two can be compared.
fs::path plain(const fs::path& folder) {
  fs::path whole = whole_path(folder);
  if (!whole.has_filename() && whole.has_relative_path()) whole = whole.parent_path();
  return whole;
}

fs::path own_faces() {
  const auto folder = folder_of_own_faces();
  return folder ? plain(*folder) : fs::path();
}

/// Whether two paths lead to the same folder.
bool same_folder(const fs::path& a, const fs::path& b) {
  std::error_code gone;
  return a == b || fs::equivalent(a, b, gone);
}

}  // namespace

FaceSession::FaceSession(Assets& assets)
    : assets_(assets), copies_(plain(assets.data_folder / "faces")) {
  shown_from(assets.face_folder);
}

Result<std::vector<std::string>> FaceSession::show(const fs::path& folder) {
  auto face = face::load_face(folder, assets_.data_folder);
  if (!face) return face.error();
  for (const std::string& remark : face->remarks) spdlog::warn("{}", remark);
  std::vector<std::string> before;
  for (const face::Channel& channel : assets_.face.channels) before.push_back(channel.name);
  assets_.face = std::move(*face);
  ++changes_;
  const fs::path whole = plain(folder);
  const bool shipped = same_folder(whole.parent_path(), plain(assets_.data_folder / "faces"));
  next_ = shipped ? whole.filename().string() : whole.string();
  assets_.face_folder = whole;
  shown_from(whole);
  return before;
}

void FaceSession::look_in(const fs::path& folder) {
  looked_in_ = plain(folder);
  list();
}

Result<fs::path> FaceSession::copy(const fs::path& folder, const std::string& name) {
  if (auto good = check_name(name); !good) return good.error();
  const auto faces = writable_own_faces(assets_.data_folder);
  if (!faces) return faces.error();
  auto copied = gui::copy_face(folder, *faces, name);
  list();
  return copied;
}

Result<fs::path> FaceSession::rename(const fs::path& folder, const std::string& name) {
  if (auto own = check_own(folder); !own) return own.error();
  if (auto good = check_name(name); !good) return good.error();
  auto renamed = gui::rename_face(folder, name);
  list();
  return renamed;
}

Result<void> FaceSession::remove(const fs::path& folder) {
  if (auto own = check_own(folder); !own) return own;
  auto removed = gui::delete_face(folder);
  list();
  return removed;
}

Result<fs::path> FaceSession::origin(const fs::path& folder) const {
  if (auto own = check_own(folder); !own) return own.error();
  const fs::path shipped = assets_.data_folder / "faces";
  fs::path origin = gui::shipped_origin(folder, shipped);
  return origin.empty() ? shipped / "default" : std::move(origin);
}

Result<void> FaceSession::check_own(const fs::path& folder) const {
  const auto faces = writable_own_faces(assets_.data_folder);
  if (faces && same_folder(plain(folder).parent_path(), plain(faces->own))) return {};
  return Error{ErrorKind::Usage, gui::tr("said.face_not_own", folder.filename().string())};
}

Result<void> FaceSession::check_name(const std::string& name) const {
  std::string wrong = gui::wrong_face_name(name, view_);
  if (wrong.empty()) return {};
  return Error{ErrorKind::Usage, std::move(wrong)};
}

/// For a face from elsewhere, the faces beside it are listed too.
void FaceSession::shown_from(const fs::path& folder) {
  const fs::path whole = plain(folder);
  view_.shown = whole.string();
  const fs::path among = whole.parent_path();
  const fs::path shipped = plain(assets_.data_folder / "faces");
  for (const fs::path& known : {shipped, own_faces()}) {
    if (!same_folder(among, known)) continue;
    // The same face, under its name in the list.
    view_.shown = (known / whole.filename()).string();
    return list();
  }
  if (copies_.contain(whole)) {
    view_.shown = (shipped / whole.filename()).string();
    return list();
  }
  looked_in_ = among;
  list();
}

void FaceSession::list() {
  const fs::path shipped = plain(assets_.data_folder / "faces");
  std::vector<gui::FaceEntry> entries;
  const auto add = [&](const fs::path& folder, gui::FaceKind kind) {
    if (folder.empty()) return;
    for (gui::FaceEntry& entry : gui::faces_in(folder)) {
      if (kind == gui::FaceKind::Elsewhere && copies_.contain(entry.folder)) continue;
      entry.kind = kind;
      entries.push_back(std::move(entry));
    }
  };
  add(shipped, gui::FaceKind::Shipped);
  // Who has the shipped ones in the place of one's own has none that may be deleted.
  const auto faces = writable_own_faces(assets_.data_folder);
  if (faces) add(plain(faces->own), gui::FaceKind::Own);
  const bool listed = same_folder(looked_in_, shipped) || same_folder(looked_in_, own_faces());
  if (!listed) add(looked_in_, gui::FaceKind::Elsewhere);
  view_.elsewhere = looked_in_.string();
  view_.entries = std::make_shared<const std::vector<gui::FaceEntry>>(std::move(entries));
}

}  // namespace aucast::app
