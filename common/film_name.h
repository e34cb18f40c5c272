#pragma once

#include <filesystem>

namespace aucast {

/// Whether a path names a film, by its ending: .mp4, .mov, .mkv, .webm, ...
[[nodiscard]] bool is_film(const std::filesystem::path& path);

}  // namespace aucast
