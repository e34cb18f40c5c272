#include "client/app/window/making/face_commands.h"

#include <variant>

#include "client/gui/texts/texts.h"
#include "common/overloaded.h"

namespace aucast::app {
namespace {

namespace fs = std::filesystem;

Result<std::string> copy(const gui::CopyFace& wanted, FaceSession& faces, const ShowFolder& show) {
  const auto copy = faces.copy(wanted.folder, wanted.name);
  if (!copy) return copy.error();
  if (auto shown = show(*copy); !shown) return shown.error();
  return gui::tr("said.face_copied", wanted.name, copy->string());
}

Result<std::string> rename(const gui::RenameFace& wanted, FaceSession& faces,
                           const ShowFolder& show) {
  const bool is_shown = faces.view().shown == wanted.folder;
  const auto renamed = faces.rename(wanted.folder, wanted.name);
  if (!renamed) return renamed.error();
  if (is_shown) {
    if (auto shown = show(*renamed); !shown) return shown.error();
  }
  return gui::tr("said.face_renamed", wanted.name, renamed->string());
}

/// The face in the window is exchanged before it is deleted.
Result<std::string> remove(const gui::DeleteFace& wanted, FaceSession& faces,
                           const ShowFolder& show) {
  const auto origin = faces.origin(wanted.folder);
  if (!origin) return origin.error();
  const bool is_shown = faces.view().shown == wanted.folder;
  if (is_shown) {
    if (auto shown = show(*origin); !shown) return shown.error();
  }
  if (auto removed = faces.remove(wanted.folder); !removed) {
    // It is still there, unless the disk is at fault: what was wrong there is what is said.
    if (is_shown) static_cast<void>(show(wanted.folder));
    return removed.error();
  }
  return gui::tr("said.face_deleted", fs::path(wanted.folder).filename().string());
}

}  // namespace

Result<std::string> carry_out(const gui::FaceCommand& command, FaceSession& faces,
                              const ShowFolder& show) {
  return std::visit(
      Overloaded{[&](const gui::ShowFace& one) -> Result<std::string> {
                   if (auto shown = show(one.folder); !shown) return shown.error();
                   return std::string();
                 },
                 [&](const gui::CopyFace& one) { return copy(one, faces, show); },
                 [&](const gui::RenameFace& one) { return rename(one, faces, show); },
                 [&](const gui::DeleteFace& one) { return remove(one, faces, show); }},
      command);
}

}  // namespace aucast::app
