#pragma once

#include <span>
#include <string>

#include <glm/vec3.hpp>

#include "client/face/face_mesh.h"

namespace aucast::app {

/// The skin of a face as Wavefront OBJ: vertices and triangles of the part `skin`. The vertices are
/// in the order of the face's file, with nine decimals so that the same floats are read back;
/// what view::RoundedMesh adds to pictures is not there.
/// `positions`: those of the whole mesh.
[[nodiscard]] std::string format_obj(const face::FaceMesh& mesh,
                                     std::span<const glm::vec3> positions);

}  // namespace aucast::app
