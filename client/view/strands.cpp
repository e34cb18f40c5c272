#include "client/view/strands.h"

#include "common/check.h"

namespace aucast::view {

Strands::Strands(const StaticMesh& mesh, std::size_t vertex_count) {
  for (const float number : mesh.strand) strands_.emplace_back(0, 0, 0, number);
  strands_.resize(vertex_count);
  if (mesh.strand.empty()) return;
  for (const MaterialRange& range : mesh.ranges) {
    if (range.material.shader != Shader::Hair) continue;
    const auto hair = mesh.triangles.subspan(range.triangle_begin, range.triangle_count);
    triangles_.insert(triangles_.end(), hair.begin(), hair.end());
  }
}

std::span<const glm::vec4> Strands::place(std::span<const glm::vec3> positions) {
  for (const auto& corners : triangles_) {
    for (const std::uint32_t i : corners) strands_[i] = {0, 0, 0, strands_[i].w};
  }
  for (const auto& [a, b, c] : triangles_) {
    AUCAST_CHECK(a < positions.size() && b < positions.size() && c < positions.size());
    // The direction in which the number, linear over the triangle, does not change. Larger
    // triangles count more.
    const glm::vec3 way = (positions[b] - positions[a]) * (strands_[c].w - strands_[a].w) -
                          (positions[c] - positions[a]) * (strands_[b].w - strands_[a].w);
    for (const std::uint32_t i : {a, b, c}) strands_[i] += glm::vec4(way, 0);
  }
  return strands_;
}

}  // namespace aucast::view
