#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/face/face.h"
#include "common/result.h"

namespace aucast::face {

/// A folder that has this file is a face of our own format.
inline constexpr const char* kFaceFile = "face.toml";

/// Reads a folder of our own format (face.toml inside; data/faces/FORMAT.md).
[[nodiscard]] Result<Face> load_face_folder(const std::filesystem::path& folder);

/// Reads an AU file (data/faces/FORMAT.md) for a face of our own format.
[[nodiscard]] Result<AuRecordings> load_aus(const std::filesystem::path& path, const Face& face);

}  // namespace aucast::face
