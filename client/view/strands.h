#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "client/view/scene.h"

namespace aucast::view {

/// The directions of strands of hair on a surface: along a strand its number (StaticMesh::strand)
/// is constant. Seen from outside, with the tips down, it grows to the right.
class Strands {
 public:
  Strands() = default;
  /// For `vertex_count` vertices, of which the mesh's own are the first.
  Strands(const StaticMesh& mesh, std::size_t vertex_count);

  /// For every vertex: in xyz the direction of the strands there, not of unit length, 0 where there
  /// are none; in w their number.
  [[nodiscard]] std::span<const glm::vec4> place(std::span<const glm::vec3> positions);

 private:
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<glm::vec4> strands_;
};

}  // namespace aucast::view
