#pragma once

#include <filesystem>

#include "common/result.h"

namespace aucast::app {

/// The folder of the user's own faces, from the environment. Fails if the environment has neither
/// XDG_DATA_HOME nor HOME.
[[nodiscard]] Result<std::filesystem::path> folder_of_own_faces();

}  // namespace aucast::app
