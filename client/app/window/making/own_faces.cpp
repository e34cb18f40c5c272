#include "client/app/window/making/own_faces.h"

#include <cstdlib>
#include <system_error>

#include "client/gui/storage/user_face.h"
#include "client/gui/texts/texts.h"

namespace aucast::app {

Result<std::filesystem::path> folder_of_own_faces() {
  return gui::user_faces_folder(std::getenv("XDG_DATA_HOME"), std::getenv("HOME"));
}

Result<std::filesystem::path> writable_own_faces(const std::filesystem::path& data_folder) {
  auto own = folder_of_own_faces();
  std::error_code not_there;
  if (own && std::filesystem::equivalent(*own, data_folder / "faces", not_there)) {
    return Error{ErrorKind::Usage, gui::tr("said.own_are_shipped", own->string())};
  }
  return own;
}

}  // namespace aucast::app
