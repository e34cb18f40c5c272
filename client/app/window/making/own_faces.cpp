#include "client/app/window/making/own_faces.h"

#include <cstdlib>

#include "client/gui/storage/user_face.h"

namespace aucast::app {

Result<std::filesystem::path> folder_of_own_faces() {
  return gui::user_faces_folder(std::getenv("XDG_DATA_HOME"), std::getenv("HOME"));
}

}  // namespace aucast::app
