#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace aucast::view {

/// Rounds off a mesh for drawing, so that its outline shows no corners: each triangle becomes four.
/// The vertex in the middle of an edge lies where a curve through both ends at right angles to
/// their normals passes (Vlachos et al., Curved PN Triangles, 2001). The mesh's own vertices keep
/// their numbers and places; those of the edges follow them. Thread: one mesh per thread.
class RoundedMesh {
 public:
  using Triangle = std::array<std::uint32_t, 3>;

  RoundedMesh() = default;
  /// `triangles` of a mesh of `vertex_count` vertices, which may have others that are not rounded.
  RoundedMesh(std::span<const Triangle> triangles, std::size_t vertex_count);

  /// Four for each that was given, in their order.
  [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }
  /// The mesh's own and those of the edges.
  [[nodiscard]] std::size_t vertex_count() const { return own_count_ + edges_.size(); }

  /// A value of each of the mesh's own vertices, then those of the edges: the mean of both ends.
  template <typename T>
  [[nodiscard]] std::vector<T> with_edges(std::span<const T> own) const {
    std::vector<T> all(own.begin(), own.end());
    all.reserve(vertex_count());
    for (const auto& [a, b] : edges_) all.push_back((own[a] + own[b]) * 0.5F);
    return all;
  }

  /// Positions and unit normals of the mesh's own vertices; makes those of the edges.
  void place(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals);
  /// Of all vertices, as place() found them.
  [[nodiscard]] std::span<const glm::vec3> positions() const { return positions_; }
  [[nodiscard]] std::span<const glm::vec3> normals() const { return normals_; }

 private:
  std::size_t own_count_ = 0;
  std::vector<std::array<std::uint32_t, 2>> edges_;
  std::vector<Triangle> triangles_;
  std::vector<glm::vec3> positions_;
  std::vector<glm::vec3> normals_;
};

}  // namespace aucast::view
