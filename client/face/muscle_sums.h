#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "client/face/face.h"
#include "client/face/vertex_block.h"

namespace aucast::face {

/// Where the muscles alone bring the vertices: the rest face plus the sum of what each does. What
/// a muscle does per unit is computed once; it is kept by block, so that a block is summed in one
/// go whatever the number of muscles.
class MuscleSums {
 public:
  explicit MuscleSums(const Face& face);

  /// One activation per muscle, finite. Adds to `moved` the blocks on which a muscle pulls that
  /// pulls otherwise than before.
  void take(std::span<const float> activations, BlockSet& moved);

  /// The block with all muscles' displacements, always summed in the muscles' order.
  void at(std::size_t block, VertexBlock& place) const;

  [[nodiscard]] const std::vector<VertexBlock>& rest() const { return rest_; }

 private:
  struct Reach {
    float activation_cap = 0;
    BlockSet blocks;
  };

  std::vector<VertexBlock> rest_;
  std::vector<Reach> reaches_;           ///< one per muscle
  std::vector<float> activations_;       ///< capped, one per muscle
  std::vector<std::uint32_t> begin_{0};  ///< pulls of block b: begin_[b] to begin_[b + 1]
  std::vector<VertexBlock> pulls_;       ///< per unit of activation
  std::vector<std::uint32_t> muscles_;   ///< whose pull it is
};

}  // namespace aucast::face
