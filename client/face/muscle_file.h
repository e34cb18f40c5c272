#pragma once

#include <vector>

#include "client/face/face_mesh.h"
#include "client/face/muscle.h"
#include "common/toml_reader.h"

namespace aucast::face {

/// Reads the [[muscle]] tables of a muscles.toml (data/faces/FORMAT.md); mirrored ones become two,
/// left before right. Masks must be maps of `mesh`. What is wrong goes to the problems.
[[nodiscard]] std::vector<Muscle> read_muscles(TableReader& document, const FaceMesh& mesh,
                                               Problems& problems);

/// The x that tells a muscle's side: of the insertion, or of the centre.
[[nodiscard]] float x_of(const MuscleShape& shape);

/// The same muscle on the other side of the face.
[[nodiscard]] MuscleShape mirrored(MuscleShape shape);

}  // namespace aucast::face
