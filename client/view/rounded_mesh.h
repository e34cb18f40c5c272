#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace aucast::view {

/// Rounds off a mesh for drawing, so that its outline shows no corners. An edge that bends gets a
/// vertex at its middle, and each of its triangles becomes two to four. The new vertex lies on a
/// curve through both ends that is at right angles to their normals (Vlachos et al., Curved PN
/// Triangles, 2001). The mesh's own vertices keep their numbers and places; those of the edges come
/// after them. Thread: one mesh per thread.
class RoundedMesh {
 public:
  using Triangle = std::array<std::uint32_t, 3>;

  RoundedMesh() = default;
  /// An edge counts as bent if its middle would move by `least_bend` (mesh units) or more on the
  /// mesh at rest. `rest` has all vertices of the mesh; `triangles` may be only some of its
  /// triangles.
  RoundedMesh(std::span<const glm::vec3> rest, std::span<const Triangle> triangles,
              float least_bend);

  [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }
  /// How many of triangles() the first `count` of the given ones were cut into.
  [[nodiscard]] std::size_t rounded_count(std::size_t count) const {
    return rounded_counts_[count];
  }
  /// The number of vertices: the mesh's own and those of the edges.
  [[nodiscard]] std::size_t vertex_count() const { return own_count_ + edges_.size(); }

  /// Takes one value per own vertex of the mesh, and adds one per edge vertex: the mean of both
  /// ends.
  template <typename T>
  [[nodiscard]] std::vector<T> with_edges(std::span<const T> own) const {
    std::vector<T> all(own.begin(), own.end());
    all.reserve(vertex_count());
    for (const auto& [a, b] : edges_) all.push_back((own[a] + own[b]) * 0.5F);
    return all;
  }

  /// Sets the positions and unit normals of the mesh's own vertices, and computes those of the
  /// edges.
  void place(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals);
  /// The positions of all vertices after place().
  [[nodiscard]] std::span<const glm::vec3> positions() const { return positions_; }
  [[nodiscard]] std::span<const glm::vec3> normals() const { return normals_; }

 private:
  void add(Triangle corners, std::array<std::uint32_t, 3> middles);

  std::size_t own_count_ = 0;
  std::vector<std::array<std::uint32_t, 2>> edges_;
  std::vector<Triangle> triangles_;
  std::vector<std::size_t> rounded_counts_{0};
  std::vector<glm::vec3> positions_;
  std::vector<glm::vec3> normals_;
};

}  // namespace aucast::view
