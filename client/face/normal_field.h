#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "client/face/block_set.h"
#include "client/face/face_mesh.h"
#include "client/face/vertex_block.h"

namespace aucast::face {

/// Vertex normals, weighted by the triangles' areas; creases take no light and have no normals.
/// Only normals near moved vertices are computed again. The triangles round a vertex make up a
/// polygon, whose area vector (along its normal) does not depend on how the polygon is cut up. So
/// it is cut into quadrangles: half as many are needed as triangles, and a quadrangle takes one
/// cross product, as a triangle does.
/// Thread: one field per thread.
class NormalField {
 public:
  /// Begins with the vertices at their rest places.
  explicit NormalField(const FaceMesh& mesh);
  class Making;

  /// Puts the vertices of a block at `at`. Their normals change only with update().
  void place(std::size_t block, const std::array<Four, kLanes>& at) {
    Four* const points = &points_[block * kLanes];
    for (std::size_t i = 0; i < kLanes; ++i) points[i] = at[i];
  }

  /// Writes the `normals` that may have changed and leaves all others alone. `moved`: the blocks
  /// that were placed anew since the last update. Normals have unit length; a vertex gets +z if
  /// none of its triangles has an area. Normals of creases are left alone or set to +z.
  void update(const BlockSet& moved, std::span<glm::vec3> normals);

 private:
  NormalField() = default;

  /// Blocks whose bits lie in one word of a BlockSet.
  struct Neighbours {
    std::size_t word = 0;
    std::uint64_t bits = 0;
  };

  /// Sets touched_ to the blocks whose normals change when the blocks in `moved` have moved.
  void touch(const BlockSet& moved);
  void update_some(std::span<const std::size_t> blocks, std::span<glm::vec3> normals) const;
  void add_areas(std::size_t half, Four* sums) const;

  std::vector<Four> points_;
  /// The corners of the polygons round the four vertices of half block h are corners_begin_[h] to
  /// corners_begin_[h + 1]. They come in pairs: the first pair of each vertex, then the second pair
  /// of each, and so on. All four vertices have equally many: those with fewer are filled up with
  /// pairs that add no area. Each pair after the first makes a quadrangle with its vertex's first
  /// corner and the corner before the pair. A corner is stored as its distance in bytes from the
  /// first point, which saves a shift.
  std::vector<std::uint32_t> corners_;
  std::vector<std::uint32_t> corners_begin_{0};
  /// The neighbours of block b, stored likewise: b itself and the blocks that share a triangle with
  /// b; none if b has only creases.
  std::vector<Neighbours> neighbours_;
  std::vector<std::uint32_t> neighbours_begin_{0};
  BlockSet moved_;    ///< the argument of the last touch()
  BlockSet touched_;  ///< the blocks whose normals may change when moved_ have moved
};

/// Makes a NormalField in portions of about a millisecond. The mesh must outlive it.
class NormalField::Making {
 public:
  explicit Making(const FaceMesh& mesh);
  ~Making();
  Making(const Making&) = delete;
  Making& operator=(const Making&) = delete;

  /// Does the next portion. Returns true when all are done; then call finish().
  [[nodiscard]] bool step();
  [[nodiscard]] NormalField finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace aucast::face
