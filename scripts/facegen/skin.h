#pragma once

#include <vector>

#include "scripts/facegen/layout.h"
#include "scripts/facegen/part.h"

namespace aucast::facegen {

/// The whole skin: the half head and its exact mirror image, every vertex knowing its place in the
/// layout. Vertices of the half come first, in its order, then the mirrors of those off the
/// midline.
struct Skin {
  HalfHead half;
  Part part;
  std::vector<std::uint32_t> source;  ///< per vertex: its index in `half`
  std::vector<int> side;              ///< per vertex: 1 left (x > 0), -1 right, 0 midline

  /// The vertex at a ring and spoke of a polar patch on the left (1) or right (-1) side; on the
  /// midline both are the same.
  [[nodiscard]] std::uint32_t find(Patch patch, int ring, int spoke, int on_side) const;
};

/// Mirrors the half head and joins both halves along the midline.
[[nodiscard]] Skin make_skin(HalfHead half);

}  // namespace aucast::facegen
