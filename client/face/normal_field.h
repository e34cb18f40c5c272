#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "client/face/face_mesh.h"
#include "client/face/vertex_block.h"

namespace aucast::face {

/// Vertex normals, weighted by the triangles' areas. Only what has a moved vertex near is computed
/// again. Copies share what depends on the mesh alone.
/// Thread: one field per thread.
class NormalField {
 public:
  /// With the vertices at their rest places.
  explicit NormalField(const FaceMesh& mesh);

  /// Puts the vertices of a block somewhere else. Normals follow with update().
  void place(std::size_t block, const std::array<Four, kLanes>& at);

  /// `moved`: one flag per block whose vertices are elsewhere since the last update. Writes those
  /// `normals` that this may change and leaves the others alone; unit length, and +z for a vertex
  /// without a triangle that has an area.
  void update(std::span<const std::uint8_t> moved, std::span<glm::vec3> normals);

  /// One flag per block: whether the last update wrote its normals.
  [[nodiscard]] const std::vector<std::uint8_t>& written() const { return written_; }

  /// Writes the normals of these blocks, whatever moved, and no others.
  void compute(std::span<const std::uint32_t> blocks, std::span<glm::vec3> normals);

  /// The blocks whose vertices compute() with these blocks reads.
  [[nodiscard]] std::vector<std::uint32_t> read_by(std::span<const std::uint32_t> blocks) const;

 private:
  struct Topology;

  void compute_group(std::size_t group);
  void compute_block(std::size_t block, std::span<glm::vec3> normals) const;

  std::shared_ptr<const Topology> mesh_;
  std::vector<Four> points_;
  std::vector<Four> areas_;            ///< one per triangle, and a zero
  std::vector<std::uint8_t> touched_;  ///< one flag per group of triangles
  std::vector<std::uint8_t> written_;
};

}  // namespace aucast::face
