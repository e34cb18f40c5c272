#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "client/face/block_set.h"
#include "client/face/face.h"

namespace aucast::face {

/// For each vertex, whether it belongs to a crease.
[[nodiscard]] std::vector<bool> crease_vertices(const FaceMesh& mesh);

/// The blocks with a vertex that belongs to no crease.
[[nodiscard]] BlockSet always_drawn(const FaceMesh& mesh);

/// Which blocks of vertices belong to something that is drawn: everything but the creases of depth
/// 0, of which an expression leaves most. What is not drawn need not move.
class DrawnBlocks {
 public:
  /// With no crease drawn.
  explicit DrawnBlocks(const Face& face);

  /// One activation per channel.
  void take(std::span<const float> activations);

  /// Of the blocks to move leaves those that are drawn, and adds those that were not until now:
  /// whatever else changes, they have to come from their rest places.
  void narrow(BlockSet& moved) const;

  /// Not drawn any more.
  [[nodiscard]] const BlockSet& vanished() const { return vanished_; }

  /// Depth in [0,1] of every crease, in the order of the mesh's parts.
  [[nodiscard]] const std::vector<float>& depths() const { return depths_; }

 private:
  struct Crease {
    std::optional<std::size_t> channel;
    BlockSet blocks;
  };

  std::vector<Crease> creases_;
  std::vector<float> depths_;  ///< one per crease
  BlockSet always_;
  BlockSet drawn_;
  BlockSet appeared_;  ///< drawn, and not before
  BlockSet vanished_;
};

}  // namespace aucast::face
