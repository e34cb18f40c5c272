#include "client/app/window/making/face_session.h"

#include <algorithm>
#include <utility>

#include "client/app/window/making/own_faces.h"
#include "client/face/face.h"
#include "client/gui/user_face.h"
#include "common/files.h"
#include "common/log.h"

namespace aucast::app {
namespace {

namespace fs = std::filesystem;

/// One way to write the place of a folder, so that two can be compared.
fs::path plain(const fs::path& folder) {
  fs::path whole = whole_path(folder);
  if (!whole.has_filename() && whole.has_relative_path()) whole = whole.parent_path();
  return whole;
}

fs::path own_faces() {
  const auto folder = folder_of_own_faces();
  return folder ? plain(*folder) : fs::path();
}

/// However the two are reached.
bool same_folder(const fs::path& a, const fs::path& b) {
  std::error_code gone;
  return a == b || fs::equivalent(a, b, gone);
}

}  // namespace

FaceSession::FaceSession(Assets& assets) : assets_(assets) {
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

/// A face from elsewhere is listed with its neighbours.
void FaceSession::shown_from(const fs::path& folder) {
  const fs::path whole = plain(folder);
  view_.shown = whole.string();
  const fs::path among = whole.parent_path();
  for (const fs::path& known : {plain(assets_.data_folder / "faces"), own_faces()}) {
    if (!same_folder(among, known)) continue;
    // The same face by the name that the list has for it.
    view_.shown = (known / whole.filename()).string();
    return list();
  }
  looked_in_ = among;
  list();
}

void FaceSession::list() {
  std::vector<gui::FaceEntry> entries;
  const auto add = [&entries](const fs::path& folder, gui::FaceKind kind) {
    if (folder.empty()) return;
    for (gui::FaceEntry& entry : gui::faces_in(folder)) {
      entry.kind = kind;
      entries.push_back(std::move(entry));
    }
  };
  add(plain(assets_.data_folder / "faces"), gui::FaceKind::Shipped);
  add(own_faces(), gui::FaceKind::Own);
  const bool listed = same_folder(looked_in_, plain(assets_.data_folder / "faces")) ||
                      same_folder(looked_in_, own_faces());
  if (!listed) add(looked_in_, gui::FaceKind::Elsewhere);
  view_.elsewhere = looked_in_.string();
  view_.entries = std::make_shared<const std::vector<gui::FaceEntry>>(std::move(entries));
}

}  // namespace aucast::app
