#include "client/view/rounded_mesh.h"

#include <algorithm>
#include <initializer_list>
#include <unordered_map>
#include <utility>

#include <glm/geometric.hpp>

#include "common/check.h"

namespace aucast::view {
namespace {

/// The vector from the middle of an edge to the middle of the curve: a cubic whose inner control
/// points lie at one and two thirds of the edge, moved into the tangent planes of its ends.
glm::vec3 bend(const glm::vec3& way, const glm::vec3& at_a, const glm::vec3& at_b) {
  return (at_b * glm::dot(way, at_b) - at_a * glm::dot(way, at_a)) * 0.125F;
}

/// The normal at the middle, from a parabola of normals, which is right too if the curve bends one
/// way and then the other.
glm::vec3 middle_normal(const glm::vec3& way, const glm::vec3& at_a, const glm::vec3& at_b) {
  const glm::vec3 sum = at_a + at_b;
  const float length2 = std::max(glm::dot(way, way), 1e-12F);
  const glm::vec3 bent = sum - way * (2 * glm::dot(way, sum) / length2);
  const glm::vec3 normal = sum + bent / std::max(glm::length(bent), 1e-6F) * 2.0F;
  return normal / std::max(glm::length(normal), 1e-6F);
}

/// Weighted by area.
std::vector<glm::vec3> normals_of(std::span<const glm::vec3> positions,
                                  std::span<const RoundedMesh::Triangle> triangles) {
  std::vector<glm::vec3> normals(positions.size(), glm::vec3(0));
  for (const auto& [a, b, c] : triangles) {
    const glm::vec3 area = glm::cross(positions[b] - positions[a], positions[c] - positions[a]);
    for (const std::uint32_t corner : {a, b, c}) normals[corner] += area;
  }
  for (glm::vec3& normal : normals) normal /= std::max(glm::length(normal), 1e-12F);
  return normals;
}

/// Takes the place of a middle vertex if the edge hardly bends.
constexpr std::uint32_t kNone = ~0U;

}  // namespace

RoundedMesh::RoundedMesh(std::span<const glm::vec3> rest, std::span<const Triangle> triangles,
                         float least_bend)
    : own_count_(rest.size()) {
  const std::vector<glm::vec3> normals = normals_of(rest, triangles);
  std::unordered_map<std::uint64_t, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    if (a > b) std::swap(a, b);
    const auto [found, is_new] = middles.try_emplace(std::uint64_t{a} << 32U | b, kNone);
    if (is_new && glm::length(bend(rest[b] - rest[a], normals[a], normals[b])) >= least_bend) {
      found->second = static_cast<std::uint32_t>(vertex_count());
      edges_.push_back({a, b});
    }
    return found->second;
  };
  for (const Triangle& t : triangles) {
    add(t, {middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0])});
    rounded_counts_.push_back(triangles_.size());
  }
}

void RoundedMesh::add(Triangle t, std::array<std::uint32_t, 3> m) {
  const auto bent = 3 - std::count(m.begin(), m.end(), kNone);
  // Turned so that the edges that bend come first.
  while (bent > 0 && bent < 3 &&
         (m[0] == kNone || m[static_cast<std::size_t>(bent) - 1] == kNone)) {
    std::rotate(t.begin(), t.begin() + 1, t.end());
    std::rotate(m.begin(), m.begin() + 1, m.end());
  }
  const auto put = [this](std::initializer_list<Triangle> all) {
    triangles_.insert(triangles_.end(), all);
  };
  if (bent == 0) put({t});
  if (bent == 1) put({{t[0], m[0], t[2]}, {m[0], t[1], t[2]}});
  if (bent == 2) put({{m[0], t[1], m[1]}, {t[0], m[0], m[1]}, {t[0], m[1], t[2]}});
  if (bent == 3) {
    put({{t[0], m[0], m[2]}, {m[0], t[1], m[1]}, {m[2], m[1], t[2]}, {m[0], m[1], m[2]}});
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
    positions_[own_count_ + i] =
        (positions[a] + positions[b]) * 0.5F + bend(way, normals[a], normals[b]);
    normals_[own_count_ + i] = middle_normal(way, normals[a], normals[b]);
  }
}

}  // namespace aucast::view
