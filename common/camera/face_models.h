#pragma once

#include <filesystem>
#include <string>

#include "common/mesh/au_weights.h"
#include "common/mesh/face_tracker.h"
#include "common/result.h"

namespace aucast::camera {

/// What is needed to read faces: the nets, which are fetched at install, and our own weights.
struct FaceModels {
  mesh::FaceTracker tracker;
  mesh::AuWeights weights;
};

/// Loads nets and weights from the project's data folder (find_data_folder()). Fails with
/// Unreadable and the remedy if the nets are not there.
[[nodiscard]] Result<FaceModels> load_face_models();

/// The same from the data folder `data`.
[[nodiscard]] Result<FaceModels> load_face_models(const std::filesystem::path& data);

}  // namespace aucast::camera
