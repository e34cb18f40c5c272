#pragma once

#include <span>
#include <string>

#include <glm/vec3.hpp>

#include "client/face/face_mesh.h"

namespace aucast::app {

/// The skin of a face as Wavefront OBJ: the vertices of the part `skin` in the order of the face's
/// file, with nine decimals so that the same floats are read back, and its triangles. `positions`:
/// those of the whole mesh.
[[nodiscard]] std::string format_obj(const face::FaceMesh& mesh,
                                     std::span<const glm::vec3> positions);

}  // namespace aucast::app
