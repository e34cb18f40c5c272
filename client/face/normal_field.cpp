#include "client/face/normal_field.h"

#include <algorithm>
#include <cmath>

#include "client/face/vertex_block.h"

namespace aucast::face {
namespace {

constexpr std::size_t kGroupTriangles = 16;

}  // namespace

NormalField::Lists NormalField::lists_of(std::vector<std::vector<std::uint32_t>> lists) {
  Lists result;
  result.begin.push_back(0);
  for (auto& list : lists) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    result.items.insert(result.items.end(), list.begin(), list.end());
    result.begin.push_back(static_cast<std::uint32_t>(result.items.size()));
  }
  return result;
}

NormalField::NormalField(const FaceMesh& mesh)
    : triangles_(mesh.triangles), rest_normals_(mesh.positions.size()) {
  const std::size_t blocks = block_count(mesh.positions.size());
  const std::size_t groups = (triangles_.size() + kGroupTriangles - 1) / kGroupTriangles;
  std::vector<std::vector<std::uint32_t>> of_vertex(mesh.positions.size());
  std::vector<std::vector<std::uint32_t>> of_block(blocks);
  std::vector<std::vector<std::uint32_t>> of_group(groups);
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const std::size_t group = i / kGroupTriangles;
    for (const std::uint32_t vertex : triangles_[i]) {
      of_vertex[vertex].push_back(static_cast<std::uint32_t>(i));
      of_block[vertex / kLanes].push_back(static_cast<std::uint32_t>(group));
      of_group[group].push_back(static_cast<std::uint32_t>(vertex / kLanes));
    }
  }
  triangles_of_vertex_ = lists_of(std::move(of_vertex));
  groups_of_block_ = lists_of(std::move(of_block));
  blocks_of_group_ = lists_of(std::move(of_group));
  area_normals_.resize(triangles_.size());
  group_touched_.resize(groups);
  group_needed_.resize(groups);
  block_affected_.resize(blocks);
  for (std::size_t group = 0; group < groups; ++group) compute_group(group, mesh.positions);
  for (std::size_t i = 0; i < rest_normals_.size(); ++i) rest_normals_[i] = vertex_normal(i);
}

void NormalField::mark(std::span<const std::uint8_t> moved) {
  std::fill(group_touched_.begin(), group_touched_.end(), std::uint8_t{0});
  std::fill(group_needed_.begin(), group_needed_.end(), std::uint8_t{0});
  std::fill(block_affected_.begin(), block_affected_.end(), std::uint8_t{0});
  for (std::size_t block = 0; block < moved.size(); ++block) {
    if (moved[block] == 0) continue;
    for (const std::uint32_t group : groups_of_block_[block]) group_touched_[group] = 1;
  }
  for (std::size_t group = 0; group < group_touched_.size(); ++group) {
    if (group_touched_[group] == 0) continue;
    for (const std::uint32_t block : blocks_of_group_[group]) block_affected_[block] = 1;
  }
  for (std::size_t block = 0; block < block_affected_.size(); ++block) {
    if (block_affected_[block] == 0) continue;
    for (const std::uint32_t group : groups_of_block_[block]) group_needed_[group] = 1;
  }
}

void NormalField::compute_group(std::size_t group, std::span<const glm::vec3> positions) {
  const std::size_t begin = group * kGroupTriangles;
  const std::size_t end = std::min(begin + kGroupTriangles, triangles_.size());
  for (std::size_t i = begin; i < end; ++i) {
    const glm::vec3& a = positions[triangles_[i][0]];
    const glm::vec3& b = positions[triangles_[i][1]];
    const glm::vec3& c = positions[triangles_[i][2]];
    const float ux = b.x - a.x;
    const float uy = b.y - a.y;
    const float uz = b.z - a.z;
    const float vx = c.x - a.x;
    const float vy = c.y - a.y;
    const float vz = c.z - a.z;
    area_normals_[i].xyz = {uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx, 0};
  }
}

glm::vec3 NormalField::vertex_normal(std::size_t vertex) const {
  std::array<float, 4> sum{};
  for (const std::uint32_t triangle : triangles_of_vertex_[vertex]) {
    for (std::size_t k = 0; k < 4; ++k) sum[k] += area_normals_[triangle].xyz[k];
  }
  const float length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
  if (!(length > 0)) return {0, 0, 1};
  return {sum[0] / length, sum[1] / length, sum[2] / length};
}

void NormalField::compute(std::span<const std::uint8_t> moved, std::span<const glm::vec3> positions,
                          std::span<glm::vec3> normals) {
  mark(moved);
  for (std::size_t group = 0; group < group_needed_.size(); ++group) {
    if (group_needed_[group] != 0) compute_group(group, positions);
  }
  for (std::size_t block = 0; block < block_affected_.size(); ++block) {
    const std::size_t begin = block * kLanes;
    const std::size_t end = std::min(begin + kLanes, normals.size());
    if (block_affected_[block] != 0) {
      for (std::size_t i = begin; i < end; ++i) normals[i] = vertex_normal(i);
    } else {
      for (std::size_t i = begin; i < end; ++i) normals[i] = rest_normals_[i];
    }
  }
}

}  // namespace aucast::face
