#include "client/app/window/making/own_faces.h"

#include <cstdlib>
#include <system_error>

#include "client/gui/storage/user_face.h"
#include "client/gui/texts/texts.h"

namespace aucast::app {

Result<std::filesystem::path> folder_of_own_faces() {
  return gui::user_faces_folder(std::getenv("XDG_DATA_HOME"), std::getenv("HOME"));
}

Result<gui::FaceFolders> writable_own_faces(const std::filesystem::path& data_folder) {
  auto own = folder_of_own_faces();
  if (!own) return own.error();
  gui::FaceFolders faces{data_folder / "faces", *std::move(own)};
  std::error_code not_there;
  if (std::filesystem::equivalent(faces.own, faces.shipped, not_there)) {
    return Error{ErrorKind::Usage, gui::tr("said.own_are_shipped", faces.own.string())};
  }
  return faces;
}

}  // namespace aucast::app
