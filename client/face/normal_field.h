#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "client/face/face_mesh.h"

namespace aucast::face {

/// Vertex normals, weighted by the triangles' areas. Only what has a moved vertex near is computed
/// again; the rest keeps the normals of the rest face.
/// Thread: one field per thread; it holds scratch memory.
class NormalField {
 public:
  explicit NormalField(const FaceMesh& mesh);

  /// `moved`: one flag per block of kLanes vertices. Fills all of `normals`; unit length, and +z
  /// for a vertex without a triangle that has an area.
  void compute(std::span<const std::uint8_t> moved, std::span<const glm::vec3> positions,
               std::span<glm::vec3> normals);

 private:
  /// Lists of numbers, one after the other.
  struct Lists {
    std::vector<std::uint32_t> begin;
    std::vector<std::uint32_t> items;
    [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t i) const {
      return std::span(items).subspan(begin[i], begin[i + 1] - begin[i]);
    }
  };
  /// Padded to 16 bytes, so that one is one load.
  struct alignas(16) AreaNormal {
    std::array<float, 4> xyz{};
  };

  [[nodiscard]] static Lists lists_of(std::vector<std::vector<std::uint32_t>> lists);
  void mark(std::span<const std::uint8_t> moved);
  void compute_group(std::size_t group, std::span<const glm::vec3> positions);
  [[nodiscard]] glm::vec3 vertex_normal(std::size_t vertex) const;

  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<glm::vec3> rest_normals_;
  Lists triangles_of_vertex_;
  Lists groups_of_block_;  ///< triangles are handled in groups, vertices in blocks
  Lists blocks_of_group_;
  std::vector<AreaNormal> area_normals_;     ///< one per triangle
  std::vector<std::uint8_t> group_touched_;  ///< has a moved vertex
  std::vector<std::uint8_t> group_needed_;   ///< shares a vertex with a touched one
  std::vector<std::uint8_t> block_affected_;
};

}  // namespace aucast::face
