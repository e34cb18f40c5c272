#include "client/face/normal_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace aucast::face {
namespace {

/// Triangles are computed in groups, vertices in blocks: marking each alone would cost as much as
/// it saves.
constexpr std::size_t kGroupTriangles = 8;

/// Lists of numbers, one after the other.
struct Lists {
  std::vector<std::uint32_t> begin{0};
  std::vector<std::uint32_t> items;
  [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t i) const {
    return std::span(items).subspan(begin[i], begin[i + 1] - begin[i]);
  }
  void end_list() { begin.push_back(static_cast<std::uint32_t>(items.size())); }
};

Lists without_repetition(std::vector<std::vector<std::uint32_t>> lists) {
  Lists result;
  for (auto& list : lists) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    result.items.insert(result.items.end(), list.begin(), list.end());
    result.end_list();
  }
  return result;
}

/// Elements are found by their distance in bytes from the first one, which saves a shift for every
/// corner of every triangle.
constexpr std::uint32_t kBytes = sizeof(Four);

const Four& at(const Four* first, std::uint32_t bytes) {
  return *reinterpret_cast<const Four*>(reinterpret_cast<const std::byte*>(first) + bytes);
}

Four yzx(Four v) {
  return __builtin_shufflevector(v, v, 1, 2, 0, 3);
}

}  // namespace

struct NormalField::Topology {
  std::size_t vertex_count = 0;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< in bytes
  /// Of each block: the triangles of its vertices, one vertex after the other, as often as the
  /// vertex with the most of them needs; the others fill up with the zero area. In
  /// bytes.
  Lists rings;
  Lists groups_of_block;
  Lists neighbours;  ///< of each block: those that share a triangle with it, and itself
};

NormalField::NormalField(const FaceMesh& mesh)
    : points_(kLanes * block_count(mesh.positions.size())) {
  auto topology = std::make_shared<Topology>();
  topology->vertex_count = mesh.positions.size();
  for (const auto& [a, b, c] : mesh.triangles) {
    topology->triangles.push_back({kBytes * a, kBytes * b, kBytes * c});
  }
  const std::size_t blocks = block_count(mesh.positions.size());
  const std::size_t groups = (mesh.triangles.size() + kGroupTriangles - 1) / kGroupTriangles;
  std::vector<std::vector<std::uint32_t>> of_vertex(blocks * kLanes);
  std::vector<std::vector<std::uint32_t>> of_block(blocks);
  std::vector<std::vector<std::uint32_t>> near_block(blocks);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::size_t group = i / kGroupTriangles;
    for (const std::uint32_t vertex : mesh.triangles[i]) {
      of_vertex[vertex].push_back(static_cast<std::uint32_t>(i));
      of_block[vertex / kLanes].push_back(static_cast<std::uint32_t>(group));
      for (const std::uint32_t other : mesh.triangles[i]) {
        near_block[vertex / kLanes].push_back(static_cast<std::uint32_t>(other / kLanes));
      }
    }
  }
  const auto zero_area = static_cast<std::uint32_t>(mesh.triangles.size());
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::span ring_of(of_vertex.data() + block * kLanes, kLanes);
    std::size_t most = 0;
    for (const auto& ring : ring_of) most = std::max(most, ring.size());
    for (std::size_t k = 0; k < most; ++k) {
      for (const auto& ring : ring_of) {
        topology->rings.items.push_back(kBytes * (k < ring.size() ? ring[k] : zero_area));
      }
    }
    topology->rings.end_list();
  }
  topology->groups_of_block = without_repetition(std::move(of_block));
  topology->neighbours = without_repetition(std::move(near_block));
  mesh_ = std::move(topology);
  areas_.resize(mesh.triangles.size() + 1);
  touched_.resize(groups);
  written_.resize(blocks);
  const std::vector<VertexBlock> rest = blocks_of(mesh.positions);
  for (std::size_t block = 0; block < blocks; ++block) place(block, points_of(rest[block]));
  for (std::size_t group = 0; group < groups; ++group) compute_group(group);
}

void NormalField::place(std::size_t block, const std::array<Four, kLanes>& at) {
  for (std::size_t i = 0; i < kLanes; ++i) points_[block * kLanes + i] = at[i];
}

/// Twice the area as a vector along the normal, with its coordinates turned: (z, x, y).
void NormalField::compute_group(std::size_t group) {
  const std::size_t begin = group * kGroupTriangles;
  const std::size_t end = std::min(begin + kGroupTriangles, mesh_->triangles.size());
  const auto* const triangles = mesh_->triangles.data();
  const Four* const points = points_.data();
  for (std::size_t i = begin; i < end; ++i) {
    const Four a = at(points, triangles[i][0]);
    const Four u = at(points, triangles[i][1]) - a;
    const Four v = at(points, triangles[i][2]) - a;
    areas_[i] = u * yzx(v) - yzx(u) * v;
  }
}

void NormalField::compute_block(std::size_t block, std::span<glm::vec3> normals) const {
  const std::span<const std::uint32_t> ring = mesh_->rings[block];
  const Four* const areas = areas_.data();
  std::array<Four, kLanes> sums;
  Lanes squared;
  for (std::size_t half = 0; half < kLanes; half += 4) {
    Four sum0{};
    Four sum1{};
    Four sum2{};
    Four sum3{};
    for (std::size_t k = half; k < ring.size(); k += kLanes) {
      sum0 += at(areas, ring[k]);
      sum1 += at(areas, ring[k + 1]);
      sum2 += at(areas, ring[k + 2]);
      sum3 += at(areas, ring[k + 3]);
    }
    // The coordinates side by side, so that the square roots are taken together.
    const Four xy01 = __builtin_shufflevector(sum0, sum1, 1, 5, 2, 6);
    const Four xy23 = __builtin_shufflevector(sum2, sum3, 1, 5, 2, 6);
    const Four zw01 = __builtin_shufflevector(sum0, sum1, 0, 4, 3, 7);
    const Four zw23 = __builtin_shufflevector(sum2, sum3, 0, 4, 3, 7);
    const Four x = __builtin_shufflevector(xy01, xy23, 0, 1, 4, 5);
    const Four y = __builtin_shufflevector(xy01, xy23, 2, 3, 6, 7);
    const Four z = __builtin_shufflevector(zw01, zw23, 0, 1, 4, 5);
    const Four of_four = x * x + y * y + z * z;
    std::memcpy(&squared[half], &of_four, sizeof of_four);
    sums[half] = yzx(sum0);
    sums[half + 1] = yzx(sum1);
    sums[half + 2] = yzx(sum2);
    sums[half + 3] = yzx(sum3);
  }
  Lanes inverse;
  int flat = 0;
  for (std::size_t i = 0; i < kLanes; ++i) {
    inverse[i] = 1 / std::sqrt(squared[i]);
    flat += squared[i] > 0 ? 0 : 1;
  }
  for (std::size_t i = 0; i < kLanes; ++i) sums[i] *= inverse[i];
  for (std::size_t i = 0; flat > 0 && i < kLanes; ++i) {
    if (!(squared[i] > 0)) sums[i] = Four{0, 0, 1, 0};
  }
  write_points(sums, block_of(normals, block));
}

void NormalField::update(std::span<const std::uint8_t> moved, std::span<glm::vec3> normals) {
  std::fill(written_.begin(), written_.end(), std::uint8_t{0});
  if (none(moved)) return;
  std::fill(touched_.begin(), touched_.end(), std::uint8_t{0});
  for (std::size_t block = 0; block < moved.size(); ++block) {
    if (moved[block] == 0) continue;
    for (const std::uint32_t group : mesh_->groups_of_block[block]) touched_[group] = 1;
    for (const std::uint32_t other : mesh_->neighbours[block]) written_[other] = 1;
  }
  // A triangle without a moved corner is as it was.
  for (std::size_t group = 0; group < touched_.size(); ++group) {
    if (touched_[group] != 0) compute_group(group);
  }
  for (std::size_t block = 0; block < written_.size(); ++block) {
    if (written_[block] != 0) compute_block(block, normals);
  }
}

void NormalField::compute(std::span<const std::uint32_t> blocks, std::span<glm::vec3> normals) {
  std::fill(touched_.begin(), touched_.end(), std::uint8_t{0});
  for (const std::uint32_t block : blocks) {
    for (const std::uint32_t group : mesh_->groups_of_block[block]) {
      if (touched_[group] == 0) compute_group(group);
      touched_[group] = 1;
    }
  }
  for (const std::uint32_t block : blocks) compute_block(block, normals);
}

std::vector<std::uint32_t> NormalField::read_by(std::span<const std::uint32_t> blocks) const {
  std::vector<std::uint32_t> read;
  for (const std::uint32_t block : blocks) {
    const auto near_block = mesh_->neighbours[block];
    read.insert(read.end(), near_block.begin(), near_block.end());
  }
  std::sort(read.begin(), read.end());
  read.erase(std::unique(read.begin(), read.end()), read.end());
  return read;
}

}  // namespace aucast::face
