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

/// Vertex normals, weighted by the triangles' areas; creases take no light and have none. Only what
/// has a moved vertex near is computed again. The triangles round a vertex make up a polygon whose
/// area, as a vector along its normal, does not depend on how it is cut: instead of into those
/// triangles it is cut into quadrangles, each of them one cross product, and the triangles
/// themselves are never needed.
/// Thread: one field per thread.
class NormalField {
 public:
  /// With the vertices at their rest places.
  explicit NormalField(const FaceMesh& mesh);
  class Making;

  /// Puts the vertices of a block somewhere else. Normals follow with update().
  void place(std::size_t block, const std::array<Four, kLanes>& at) {
    Four* const points = &points_[block * kLanes];
    for (std::size_t i = 0; i < kLanes; ++i) points[i] = at[i];
  }

  /// `moved`: the blocks whose vertices are elsewhere since the last update. Writes those `normals`
  /// that this may change and leaves the others alone; unit length, and +z for a vertex without a
  /// triangle that has an area. What belongs to creases is left alone or +z.
  void update(const BlockSet& moved, std::span<glm::vec3> normals);

 private:
  NormalField() = default;

  /// Blocks with neighbouring numbers.
  struct Neighbours {
    std::size_t word = 0;
    std::uint64_t bits = 0;
  };

  /// Finds what to compute when these have moved.
  void touch(const BlockSet& moved);
  void update_some(std::span<const std::size_t> blocks, std::span<glm::vec3> normals) const;
  void add_areas(std::size_t half, Four* sums) const;

  std::vector<Four> points_;
  /// Corners for half block h: corners_begin_[h] to corners_begin_[h + 1]. Two of each of its
  /// vertices, two more of each, and so on, as often as the vertex with the most of them needs, the
  /// others repeating themselves. The first is where all is seen from, the second one begins, and
  /// two more make a quadrangle with the first and the last one before. As distances in bytes from
  /// the first point, which saves a shift for each of them.
  std::vector<std::uint32_t> corners_;
  std::vector<std::uint32_t> corners_begin_{0};
  /// Likewise, of each block those that share a triangle with it, and itself; none if it is all
  /// crease.
  std::vector<Neighbours> neighbours_;
  std::vector<std::uint32_t> neighbours_begin_{0};
  BlockSet moved_;    ///< the last time
  BlockSet touched_;  ///< whose normals may change when those have moved
};

/// NormalField in portions of about a millisecond. The mesh must outlive it.
class NormalField::Making {
 public:
  explicit Making(const FaceMesh& mesh);
  ~Making();
  Making(const Making&) = delete;
  Making& operator=(const Making&) = delete;

  /// Does the next portion. True when all are done: then finish().
  [[nodiscard]] bool step();
  [[nodiscard]] NormalField finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace aucast::face
