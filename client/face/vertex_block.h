#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "client/face/block_set.h"

namespace aucast::face {

/// Vertices are moved eight at a time, their coordinates side by side, so that the compiler makes
/// vector instructions of plain loops.
inline constexpr std::size_t kLanes = 8;

using Lanes = std::array<float, kLanes>;

/// Four numbers in a vector register, a type that GCC and Clang have on every processor. A point is
/// x, y, z and one unused number.
using Four = float __attribute__((vector_size(16)));

/// Eight vertices that follow each other in the mesh; lanes past the mesh's end are zero.
struct alignas(32) VertexBlock {
  Lanes x{};
  Lanes y{};
  Lanes z{};
};

/// The element that lies `bytes` after the first.
template <typename Element>
[[nodiscard]] const Element& at_distance(const Element* first, std::uint32_t bytes) {
  return *reinterpret_cast<const Element*>(reinterpret_cast<const std::byte*>(first) + bytes);
}

[[nodiscard]] inline Four in_all_lanes(float value) {
  return Four{value, value, value, value};
}

/// Four lanes, from lane `begin` (0 or 4) on.
[[nodiscard]] inline Four four_at(const Lanes& lanes, std::size_t begin) {
  Four four;
  std::memcpy(&four, &lanes[begin], sizeof four);
  return four;
}

inline void set_four(Lanes& lanes, std::size_t begin, const Four& four) {
  std::memcpy(&lanes[begin], &four, sizeof four);
}

/// The elements of block number `block`, where `points` has one element per vertex. The last block
/// may be shorter.
template <typename Points>
[[nodiscard]] auto block_of(Points& points, std::size_t block) {
  const std::size_t begin = block * kLanes;
  return std::span(points).subspan(begin, std::min(kLanes, points.size() - begin));
}

[[nodiscard]] constexpr std::size_t block_count(std::size_t vertex_count) {
  return (vertex_count + kLanes - 1) / kLanes;
}

/// The block's vertices as points; the fourth number of each is zero.
[[nodiscard]] inline std::array<Four, kLanes> points_of(const VertexBlock& block) {
  std::array<Four, kLanes> points;
  for (std::size_t i = 0; i < kLanes; i += 4) {
    const Four x = four_at(block.x, i);
    const Four y = four_at(block.y, i);
    const Four z = four_at(block.z, i);
    const Four xy01 = __builtin_shufflevector(x, y, 0, 4, 1, 5);
    const Four xy23 = __builtin_shufflevector(x, y, 2, 6, 3, 7);
    const Four z01 = __builtin_shufflevector(z, Four{}, 0, 4, 1, 5);
    const Four z23 = __builtin_shufflevector(z, Four{}, 2, 6, 3, 7);
    points[i] = __builtin_shufflevector(xy01, z01, 0, 1, 4, 5);
    points[i + 1] = __builtin_shufflevector(xy01, z01, 2, 3, 6, 7);
    points[i + 2] = __builtin_shufflevector(xy23, z23, 0, 1, 4, 5);
    points[i + 3] = __builtin_shufflevector(xy23, z23, 2, 3, 6, 7);
  }
  return points;
}

/// Calls `write` with room for the points of a whole block. Points beyond the end of `out` are
/// dropped.
template <typename Write>
void write_block(std::span<glm::vec3> out, Write write) {
  std::array<glm::vec3, kLanes> last;
  write(out.size() == kLanes ? out.data() : last.data());
  if (out.size() < kLanes) std::copy_n(last.begin(), out.size(), out.begin());
}

/// Writes the x, y and z of a block's points to `out`, which is shorter for the last block of a
/// mesh.
inline void write_points(const std::array<Four, kLanes>& points, std::span<glm::vec3> out) {
  write_block(out, [&points](glm::vec3* block) {
    // Stores whole registers: the next point overwrites the unused fourth number.
    float* to = &block->x;
    for (std::size_t i = 0; i + 1 < kLanes; ++i, to += 3) std::memcpy(to, &points[i], sizeof(Four));
    std::memcpy(to, &points[kLanes - 1], sizeof(glm::vec3));
  });
}

/// Copies in registers; an assignment would be a call of memcpy in WebAssembly.
inline void copy_block(const VertexBlock& from, VertexBlock& to) {
  for (std::size_t i = 0; i < kLanes; i += 4) {
    set_four(to.x, i, four_at(from.x, i));
    set_four(to.y, i, four_at(from.y, i));
    set_four(to.z, i, four_at(from.z, i));
  }
}

inline void set_lane(VertexBlock& block, std::size_t lane, const glm::vec3& point) {
  block.x[lane] = point.x;
  block.y[lane] = point.y;
  block.z[lane] = point.z;
}

/// Block number `block` of `points`.
[[nodiscard]] inline VertexBlock block_at(std::span<const glm::vec3> points, std::size_t block) {
  VertexBlock result;
  const std::size_t begin = block * kLanes;
  for (std::size_t i = 0; i < kLanes && begin + i < points.size(); ++i) {
    set_lane(result, i, points[begin + i]);
  }
  return result;
}

[[nodiscard]] inline std::vector<VertexBlock> blocks_of(std::span<const glm::vec3> points) {
  std::vector<VertexBlock> blocks(block_count(points.size()));
  for (std::size_t i = 0; i < blocks.size(); ++i) blocks[i] = block_at(points, i);
  return blocks;
}

/// A map's weights, for the blocks in which any of them is not zero.
struct WeightedBlocks {
  std::vector<std::uint32_t> blocks;
  BlockSet all;  ///< the same blocks
  std::vector<Lanes> weights;
};

}  // namespace aucast::face
