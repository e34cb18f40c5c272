#pragma once

#include <vector>

#include "client/face/face_mesh.h"
#include "client/face/muscle.h"
#include "common/toml_reader.h"

namespace aucast::face {

/// Reads the [[muscle]] tables of a muscles.toml (data/faces/FORMAT.md). A mirrored table becomes
/// two muscles, left before right. Masks must be maps of `mesh`. Errors are added to `problems`.
[[nodiscard]] std::vector<Muscle> read_muscles(TableReader& document, const FaceMesh& mesh,
                                               Problems& problems);

/// The x of the insertion or of the centre, which decides a muscle's side.
[[nodiscard]] float x_of(const MuscleShape& shape);

/// The same muscle on the other side of the face.
[[nodiscard]] MuscleShape mirrored(MuscleShape shape);

}  // namespace aucast::face
