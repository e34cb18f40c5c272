#pragma once

#include <filesystem>

#include "common/result.h"

namespace aucast::app {

/// The folder of the user's own faces, as the environment has it. Error when it names
/// no place for it.
[[nodiscard]] Result<std::filesystem::path> folder_of_own_faces();

}  // namespace aucast::app
