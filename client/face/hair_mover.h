#pragma once

#include <vector>

#include "client/face/block_set.h"
#include "client/face/face.h"
#include "client/face/vertex_block.h"

namespace aucast::face {

/// Swings the hair below the hinge of Face::hair, each vertex by its depth below it: the crown
/// stays, the lowest ends swing most. It comes before the head's turn, so it never tears the hair
/// off the head. Towards the head hair swings less than away from it.
/// Thread: one object per thread.
class HairMover {
 public:
  explicit HairMover(const Face& face);

  /// Sets how far the hair hangs from where it lies at rest; each share is clamped to [-1, 1]. If
  /// it differs from before, adds the blocks of the hair that swings to `moved`.
  void take(const HairSway& sway, BlockSet& moved);

  /// Swings those blocks of the mesh that are in `moved`, from where they are in `blocks`.
  void apply(const BlockSet& moved, std::vector<VertexBlock>& blocks) const;

 private:
  /// The weights of a block: of a turn, and of the other axes by the way they go.
  struct Swing {
    std::size_t block = 0;
    Lanes turn{};
    Lanes forward{};
    Lanes back{};
    Lanes left{};
    Lanes right{};
  };

  Hair hair_;
  std::vector<Swing> swings_;
  BlockSet all_;  ///< their blocks
  HairSway sway_;
};

}  // namespace aucast::face
