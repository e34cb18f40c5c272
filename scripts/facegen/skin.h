#pragma once

#include <vector>

#include "scripts/facegen/layout.h"
#include "scripts/facegen/part.h"

namespace aucast::facegen {

/// The whole skin: the half head and its exact mirror image. `source` and `side` say where each
/// vertex is in the layout. First come the vertices of the half, in the same order, then the mirror
/// images of those off the midline.
struct Skin {
  HalfHead half;
  Part part;
  std::vector<std::uint32_t> source;  ///< per vertex: its index in `half`
  std::vector<int> side;              ///< per vertex: 1 left (x > 0), -1 right, 0 midline

  /// The vertex at a ring and spoke of a polar patch on the left (1) or right (-1) side; on the
  /// midline both sides have the same vertex.
  [[nodiscard]] std::uint32_t find(Patch patch, int ring, int spoke, int on_side) const;
};

/// Mirrors the half head and joins both halves along the midline.
[[nodiscard]] Skin make_skin(HalfHead half);

}  // namespace aucast::facegen
