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

/// Depth in [0,1] of every crease when nothing drives it, in the order of the mesh's parts.
[[nodiscard]] std::vector<float> kept_depths(const Face& face);

/// Which blocks of vertices are drawn: all but those that consist of creases of depth 0. In most
/// expressions, most creases have that depth. Blocks that are not drawn need not move.
class DrawnBlocks {
 public:
  /// Begins with those creases drawn that the skin keeps.
  explicit DrawnBlocks(const Face& face);

  /// Updates which creases are drawn. `activations`: one per channel.
  void take(std::span<const float> activations);

  /// Removes from `moved` the blocks that are not drawn, and adds those that the last take() began
  /// to draw, because they were not moved before.
  void narrow(BlockSet& moved) const;

  /// The blocks that the last take() stopped drawing.
  [[nodiscard]] const BlockSet& vanished() const { return vanished_; }

  /// Depth in [0,1] of every crease, in the order of the mesh's parts.
  [[nodiscard]] const std::vector<float>& depths() const { return depths_; }

 private:
  struct Crease {
    std::optional<std::size_t> channel;
    float kept = 0;
    BlockSet blocks;
  };

  /// The blocks that are drawn with the depths of now.
  [[nodiscard]] BlockSet with_creases() const;

  std::vector<Crease> creases_;
  std::vector<float> depths_;  ///< one per crease
  BlockSet always_;
  BlockSet drawn_;
  BlockSet appeared_;  ///< the blocks that the last take() began to draw
  BlockSet vanished_;
};

}  // namespace aucast::face
