#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace aucast::face {

/// Vertices are moved eight at a time, their coordinates side by side, so that the compiler makes
/// vector instructions of plain loops.
inline constexpr std::size_t kLanes = 8;

using Lanes = std::array<float, kLanes>;

/// Eight neighbours of the mesh's vertex array; lanes past its end are zero.
struct alignas(32) VertexBlock {
  Lanes x{};
  Lanes y{};
  Lanes z{};
};

[[nodiscard]] constexpr std::size_t block_count(std::size_t vertex_count) {
  return (vertex_count + kLanes - 1) / kLanes;
}

/// Weights that are not zero somewhere in their block.
struct WeightedBlocks {
  std::vector<std::uint32_t> blocks;
  std::vector<Lanes> weights;
};

}  // namespace aucast::face
