#pragma once

#include <filesystem>

#include "common/result.h"

namespace aucast::app {

/// The folder of the user's own faces, from the environment. Fails if the environment has neither
/// XDG_DATA_HOME nor HOME.
[[nodiscard]] Result<std::filesystem::path> folder_of_own_faces();

/// The same for writing to. Fails also if it is that of the shipped faces, by a link or a setting:
/// those stay as they are.
[[nodiscard]] Result<std::filesystem::path> writable_own_faces(
    const std::filesystem::path& data_folder);

}  // namespace aucast::app
