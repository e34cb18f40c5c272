#pragma once

#include <string>

#include "client/face/face.h"

namespace aucast::glb::test {

/// Adds a part of that material with the skin's own vertices and triangles.
inline void add_part(face::Face& face, const std::string& name, face::Material material) {
  face::MeshPart part = face.mesh.parts.front();
  part.name = name;
  part.material = material;
  face.mesh.parts.push_back(part);
}

}  // namespace aucast::glb::test
