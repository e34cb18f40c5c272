#include "client/view/rounded_mesh.h"

#include <algorithm>
#include <unordered_map>

#include <glm/geometric.hpp>

#include "common/check.h"

namespace aucast::view {

RoundedMesh::RoundedMesh(std::span<const Triangle> triangles, std::size_t vertex_count)
    : own_count_(vertex_count) {
  std::unordered_map<std::uint64_t, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    if (a > b) std::swap(a, b);
    const auto next = static_cast<std::uint32_t>(vertex_count + edges_.size());
    const auto [found, is_new] = middles.try_emplace(std::uint64_t{a} << 32U | b, next);
    if (is_new) edges_.push_back({a, b});
    return found->second;
  };
  triangles_.reserve(4 * triangles.size());
  for (const auto& [a, b, c] : triangles) {
    const std::uint32_t ab = middle(a, b);
    const std::uint32_t bc = middle(b, c);
    const std::uint32_t ca = middle(c, a);
    triangles_.insert(triangles_.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
}

void RoundedMesh::place(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals) {
  AUCAST_CHECK(positions.size() == own_count_ && normals.size() == own_count_);
  positions_.resize(vertex_count());
  normals_.resize(vertex_count());
  std::copy(positions.begin(), positions.end(), positions_.begin());
  std::copy(normals.begin(), normals.end(), normals_.begin());
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const auto [a, b] = edges_[i];
    const glm::vec3 way = positions[b] - positions[a];
    const glm::vec3& at_a = normals[a];
    const glm::vec3& at_b = normals[b];
    // The middle of the cubic whose inner control points lie a third of the way along, moved into
    // the planes of the ends.
    positions_[own_count_ + i] = (positions[a] + positions[b]) * 0.5F -
                                 (at_a * glm::dot(way, at_a) - at_b * glm::dot(way, at_b)) * 0.125F;
    // Likewise the middle of a parabola that sees when the curve bends one way and then the other.
    const glm::vec3 sum = at_a + at_b;
    const float length2 = std::max(glm::dot(way, way), 1e-12F);
    const glm::vec3 bent = sum - way * (2 * glm::dot(way, sum) / length2);
    const glm::vec3 normal = sum + bent / std::max(glm::length(bent), 1e-6F) * 2.0F;
    normals_[own_count_ + i] = normal / std::max(glm::length(normal), 1e-6F);
  }
}

}  // namespace aucast::view
