#pragma once

#include <span>
#include <string>

#include <glm/vec3.hpp>

#include "client/face/face_mesh.h"

namespace aucast::app {

/// The skin of a face as Wavefront OBJ: the vertices of the part `skin` in the face file's own
/// order, nine decimals (a float read back is the same float), and its triangles. `positions` are
/// those of the whole mesh.
[[nodiscard]] std::string format_obj(const face::FaceMesh& mesh,
                                     std::span<const glm::vec3> positions);

}  // namespace aucast::app
