#pragma once

#include <filesystem>

#include "client/gui/storage/face_copies.h"
#include "common/result.h"

namespace aucast::app {

/// The folder of the user's own faces, from the environment. Fails if the environment has neither
/// XDG_DATA_HOME nor HOME.
[[nodiscard]] Result<std::filesystem::path> folder_of_own_faces();

/// The folder of the user's own faces, for writing, and that of the shipped faces. Fails as
/// folder_of_own_faces() does, or if both are the same folder (by a link or a setting), because
/// shipped faces must stay as they are.
[[nodiscard]] Result<gui::FaceFolders> writable_own_faces(const std::filesystem::path& data_folder);

}  // namespace aucast::app
