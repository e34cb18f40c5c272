#pragma once

#include <cstdint>
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

/// Adds a crease, with a channel of its name, over a patch of the small face's forehead. Its
/// vertices are its own: a face's creases do not move while they are not drawn.
inline void add_crease(face::Face& face, const std::string& name) {
  constexpr std::size_t kColumns = 41;
  constexpr std::size_t kFirst = 28 * kColumns + 20;
  constexpr std::uint32_t kSide = 10;
  face::FaceMesh& mesh = face.mesh;
  face::MeshPart part{name,
                      face::Material::Crease,
                      static_cast<std::uint32_t>(mesh.positions.size()),
                      kSide * kSide,
                      static_cast<std::uint32_t>(mesh.triangles.size()),
                      0};
  const auto copy = [](auto& values, std::size_t from) {
    if (values.empty()) return;
    const auto value = values[from];
    values.push_back(value);
  };
  for (std::uint32_t i = 0; i < part.vertex_count; ++i) {
    const std::size_t from = kFirst + i / kSide * kColumns + i % kSide;
    copy(mesh.positions, from);
    copy(mesh.colours, from);
    copy(mesh.occlusion, from);
    copy(mesh.gloss, from);
    for (auto& [map, weights] : mesh.maps) copy(weights, from);
    if (i < kSide || i % kSide == 0) continue;
    const std::uint32_t here = part.vertex_begin + i;
    mesh.triangles.push_back({here - kSide - 1, here - kSide, here});
    mesh.triangles.push_back({here - kSide - 1, here, here - 1});
  }
  part.triangle_count = static_cast<std::uint32_t>(mesh.triangles.size()) - part.triangle_begin;
  mesh.parts.push_back(part);
  face.channels.push_back({name, Side::Both, 1});
  for (auto& [number, recording] : face.recordings) recording.activation.push_back(0);
}

}  // namespace aucast::glb::test
