#pragma once

#include <array>
#include <vector>

#include "scripts/facegen/layout.h"

namespace aucast::facegen {

/// A rectangle of grid cells that a polar patch fills.
struct Block {
  int row_begin = 0;
  int row_end = 0;
  int column_begin = 0;
  int column_end = 0;

  [[nodiscard]] bool has_cell(int row, int column) const {
    return row >= row_begin && row < row_end && column >= column_begin && column < column_end;
  }
  /// Whether the node lies inside the border. A block at the midline has no border there.
  [[nodiscard]] bool has_inner_node(int row, int column) const {
    return row > row_begin && row < row_end && column < column_end &&
           (column > column_begin || column_begin == 0);
  }
};

inline constexpr Block kEyeBlock{8, 16, 4, 12};
inline constexpr Block kMouthBlock{24, 32, 0, 8};
inline constexpr Block kEarBlock{10, 20, 18, 24};
inline constexpr Block kNostrilBlock{22, 24, 2, 4};
inline constexpr std::array kBlocks{kEyeBlock, kMouthBlock, kEarBlock, kNostrilBlock};

struct GridNode {
  int row = 0;
  int column = 0;
};

/// The border of a block in the order of its spokes: along the top, down the far side, back along
/// the bottom and up the near side. The border of the mouth's block ends at the midline and has no
/// near side.
[[nodiscard]] std::vector<GridNode> border_of(const Block& block);

/// Collects vertices and quads while the half head is laid out.
class LayoutBuilder {
 public:
  explicit LayoutBuilder(const Identity& who) : who_(who) {}

  using Ring = std::vector<std::uint32_t>;

  std::uint32_t add(const Vec3& position, Patch patch, int ring = 0, int spoke = 0);
  std::uint32_t add_node(const Vec3& position, GridNode node, bool pinned);
  void add_quad(const Quad& quad) { half_.quads.push_back(quad); }
  /// Quads between an outer and an inner ring of the same length.
  void add_strip(const Ring& outer, const Ring& inner, bool closed);
  /// Quads that fill an innermost ring of even length, each with `middle` as a corner.
  void add_lid(const Ring& ring, std::uint32_t middle);

  [[nodiscard]] std::uint32_t node(int row, int column) const {
    return grid_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
  }
  [[nodiscard]] const Identity& who() const { return who_; }
  [[nodiscard]] Ring nodes(const std::vector<GridNode>& of) const;
  [[nodiscard]] const Vec3& position(std::uint32_t index) const {
    return half_.vertices[index].position;
  }
  [[nodiscard]] HalfVertex& vertex(std::uint32_t index) { return half_.vertices[index]; }
  [[nodiscard]] HalfHead take() { return std::move(half_); }

 private:
  const Identity& who_;
  HalfHead half_;
  std::array<std::array<std::uint32_t, kColumns + 1>, kRows + 1> grid_{};
};

void add_eye_patch(LayoutBuilder& builder);
void add_mouth_patch(LayoutBuilder& builder);
void add_nostril_patch(LayoutBuilder& builder);
void add_ear_patch(LayoutBuilder& builder);

}  // namespace aucast::facegen
