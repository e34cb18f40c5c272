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

/// The directions of strands of hair on a surface. Along a strand the number StaticMesh::strand is
/// constant; seen from outside, with the tips down, it grows to the right.
class Strands {
 public:
  Strands() = default;
  /// `vertex_count`: how many vertices place() gets; the mesh's own come first.
  Strands(const StaticMesh& mesh, std::size_t vertex_count);

  /// For every vertex: in xyz the direction of its strand, not of unit length (0: no strand); in w
  /// its strand number.
  [[nodiscard]] std::span<const glm::vec4> place(std::span<const glm::vec3> positions);

 private:
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<glm::vec4> strands_;
};

}  // namespace aucast::view
