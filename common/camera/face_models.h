#pragma once

#include <filesystem>
#include <string>

#include "common/mesh/au_weights.h"
#include "common/mesh/face_tracker.h"
#include "common/result.h"

namespace aucast::camera {

/// What reads faces: the nets, which are fetched at install, and our own weights.
struct FaceModels {
  mesh::FaceTracker tracker;
  mesh::AuWeights weights;
};

/// From the project's data folder (find_data_folder). Unreadable, with what to do, when the models
/// are not there.
[[nodiscard]] Result<FaceModels> load_face_models();

/// The same from a folder.
[[nodiscard]] Result<FaceModels> load_face_models(const std::filesystem::path& data);

}  // namespace aucast::camera
