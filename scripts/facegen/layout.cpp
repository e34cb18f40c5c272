#include "scripts/facegen/layout.h"

#include <algorithm>
#include <map>
#include <utility>

#include "scripts/facegen/anatomy.h"
#include "scripts/facegen/layout_builder.h"
#include "scripts/facegen/sculpt.h"

namespace aucast::facegen {
namespace {

using PointKey = Key<Vec3>;
using Pins = std::map<std::pair<int, int>, Vec3>;

struct RowCurve {
  int row = 0;
  std::size_t point_count = 0;
  std::array<PointKey, 11> points;  ///< over grid columns; only the first point_count count
};

/// Where the grid roughly runs. The points need only be within about a unit: all are projected onto
/// the sculpt and relaxed.
constexpr std::array<RowCurve, 9> kRowCurves{{
    {0,
     5,
     {{{0, {0, 9.1, 5}},
       {8, {2.4, 9, 4.1}},
       {16, {3.3, 8.9, 1.3}},
       {24, {2.5, 8.9, -1.7}},
       {32, {0, 8.9, -2.9}}}}},
    {4,
     9,
     {{{0, {0, 6.9, 7.4}},
       {4, {1.1, 6.9, 7.3}},
       {8, {2.4, 6.8, 6.7}},
       {12, {3.7, 6.7, 5.3}},
       {16, {4.6, 6.6, 3.2}},
       {20, {4.9, 6.5, 1.2}},
       {24, {4.4, 6.4, -1.6}},
       {28, {2.7, 6.3, -4.2}},
       {32, {0, 6.2, -5.1}}}}},
    {8,
     10,
     {{{0, {0, 4.5, 8.2}},
       {4, {0.9, 4.5, 8.1}},
       {8, {2.3, 4.6, 7.6}},
       {12, {3.7, 4.1, 6.2}},
       {14, {4.3, 4, 5}},
       {16, {4.7, 4, 3.6}},
       {20, {5, 4.2, 1.2}},
       {24, {4.7, 4.2, -1.6}},
       {28, {3, 4.1, -4.2}},
       {32, {0, 4, -5.2}}}}},
    {16,
     11,
     {{{0, {0, 1.3, 8.9}},
       {2, {0.35, 1.3, 8.5}},
       {4, {0.8, 1.35, 7.8}},
       {8, {2.25, 1.25, 7.3}},
       {12, {3.65, 1.5, 6.2}},
       {14, {4.3, 1.5, 4.7}},
       {16, {4.55, 1.5, 3}},
       {18, {4.6, 1.5, 1.9}},
       {24, {4.5, 1.5, -0.4}},
       {28, {3.2, 1.5, -3.2}},
       {32, {0, 1.4, -4.8}}}}},
    {24,
     9,
     {{{0, {0, -0.85, 8.7}},
       {4, {0.8, -0.78, 8.5}},
       {8, {2.2, -1.1, 7.7}},
       {12, {3.4, -1.3, 5.6}},
       {16, {3.9, -1.5, 3}},
       {18, {3.9, -1.5, 1.8}},
       {24, {3.6, -1.6, -0.5}},
       {28, {2.6, -1.5, -2.4}},
       {32, {0, -1.3, -3.4}}}}},
    {32,
     9,
     {{{0, {0, -3.9, 8.3}},
       {4, {1.15, -3.85, 7.9}},
       {8, {2.2, -3.55, 7}},
       {12, {3, -3.1, 5}},
       {16, {3.4, -2.8, 3}},
       {18, {3.3, -2.8, 1.8}},
       {24, {3, -3.2, -0.8}},
       {28, {2.2, -3.2, -2.5}},
       {32, {0, -3.2, -3.1}}}}},
    {36,
     9,
     {{{0, {0, -5.5, 7.4}},
       {4, {1, -5.35, 7}},
       {8, {2, -4.7, 5.9}},
       {12, {2.8, -4, 4.2}},
       {16, {3.1, -3.5, 2.6}},
       {18, {3, -3.6, 1.6}},
       {24, {2.9, -4.2, -0.8}},
       {28, {2.1, -4.3, -2.4}},
       {32, {0, -4.3, -3}}}}},
    {40,
     7,
     {{{0, {0, -5.9, 3.6}},
       {4, {0.9, -5.8, 3.4}},
       {8, {1.8, -5.5, 2.9}},
       {12, {2.4, -5.2, 2.2}},
       {16, {2.7, -5.2, 1.3}},
       {24, {2.4, -5.8, -1.3}},
       {32, {0, -6, -2.9}}}}},
    {48,
     5,
     {{{0, {0, -10.3, 1.6}},
       {8, {1.9, -10.2, 1.0}},
       {16, {2.9, -10.0, -0.9}},
       {24, {2.3, -9.7, -2.9}},
       {32, {0, -9.6, -3.9}}}}},
}};

Vec3 start_position(const Identity& who, int row, int column) {
  std::vector<PointKey> over_rows;
  for (const RowCurve& curve : kRowCurves) {
    const std::span<const PointKey> points{curve.points.data(), curve.point_count};
    over_rows.push_back({static_cast<double>(curve.row), sample<Vec3>(points, column)});
  }
  return on_skin(who, sample<Vec3>(over_rows, row));
}

Vec3 on_face(const Identity& who, double x, double y) {
  return {x, y, face_z(who, x, y)};
}

/// The border of the eye block: a superellipse that is wider towards the temple and higher above.
void pin_eye_border(const Identity& who, Pins& pins) {
  const auto rounded = [](double v) { return (v > 0 ? 1 : -1) * power(std::abs(v), 0.82); };
  const std::vector<GridNode> border = border_of(kEyeBlock);
  for (std::size_t i = 0; i < border.size(); ++i) {
    const double angle = radians(135 - static_cast<double>(i) * 360 / kEyeSpokes);
    const double across = rounded(std::cos(angle));
    const double up = rounded(std::sin(angle));
    pins[{border[i].row, border[i].column}] =
        on_face(who, kEyeBlockMiddle.x + (across > 0 ? 1.62 : 1.42) * across,
                kEyeBlockMiddle.y + (up > 0 ? 1.72 : 1.42) * up);
  }
}

/// The nose, where loops must lie on the groove round its wing: (x, y) for every second row 16-24
/// and column 0-8.
constexpr double kNose[5][5][2] = {
    {{0, 1.35}, {.32, 1.35}, {.80, 1.35}, {1.45, 1.15}, {2.2, 1.05}},
    {{0, .75}, {.36, .75}, {.80, .72}, {1.25, .55}, {1.95, .35}},
    {{0, .10}, {.36, .12}, {.73, .29}, {1.07, .17}, {1.75, -.20}},
    {{0, -.42}, {.32, -.42}, {.84, -.26}, {1.16, -.27}, {1.80, -.65}},
    {{0, -.84}, {.27, -.83}, {.67, -.74}, {1.03, -.68}, {2.12, -1.15}}};

void pin_nose(const Identity& who, Pins& pins) {
  for (int row = 16; row <= 24; ++row) {
    for (int column = 0; column <= 8; ++column) {
      const bool of_another = (row == 16 && column >= 4) || (row < 24 && column > 7);
      if (of_another || kNostrilBlock.has_inner_node(row, column)) continue;
      std::vector<PointKey> over_rows;
      for (int i = 0; i < 5; ++i) {
        std::vector<PointKey> over_columns;
        for (int j = 0; j < 5; ++j) {
          // Beside the nose the loops belong to the cheek.
          const double wide = j == 4 ? 1 : who.form.nose_width;
          over_columns.push_back({2.0 * j, {kNose[i][j][0] * wide, kNose[i][j][1], 0}});
        }
        over_rows.push_back({16 + 2.0 * i, sample<Vec3>(over_columns, column)});
      }
      const Vec3 at = sample<Vec3>(over_rows, row);
      pins[{row, column}] = on_face(who, column == 0 ? 0 : at.x, at.y);
    }
  }
}

/// The midline between brow and nose, which it runs on into.
void pin_bridge(const Identity& who, Pins& pins) {
  static constexpr std::array<Key<double>, 6> kHeights{
      {{8, 4.5}, {10, 3.6}, {12, 2.85}, {14, 2.1}, {16, kNose[0][0][1]}, {18, kNose[1][0][1]}}};
  for (int row = 8; row < 16; ++row) {
    pins[{row, 0}] = on_face(who, 0, sample<double>(kHeights, row));
  }
}

/// Cheek side and underside of the mouth block; its top is the base of the nose.
void pin_mouth_border(const Identity& who, Pins& pins) {
  static constexpr std::array<PointKey, 7> kBorder{{{0, {2.15, -1.15, 0}},
                                                    {2, {2.62, -1.72, 0}},
                                                    {4, {2.75, -2.40, 0}},
                                                    {6, {2.60, -3.05, 0}},
                                                    {8, {2.15, -3.55, 0}},
                                                    {12, {1.15, -3.88, 0}},
                                                    {16, {0, -3.95, 0}}}};
  const std::vector<GridNode> border = border_of(kMouthBlock);
  for (int i = 0; i <= 16; ++i) {
    const Vec3 at = sample<Vec3>(kBorder, i);
    const GridNode node = border[static_cast<std::size_t>(i + 8)];
    pins[{node.row, node.column}] = on_face(who, i == 16 ? 0 : at.x, at.y);
  }
}

/// The midline over the chin: spread evenly, its rows are too far apart for its round outline.
void pin_chin(const Identity& who, Pins& pins) {
  const double down = who.form.chin_drop;
  pins[{33, 0}] = on_face(who, 0, -4.28 - 0.6 * down);
  pins[{34, 0}] = on_face(who, 0, -4.66 - 0.8 * down);
  pins[{35, 0}] = on_face(who, 0, -5.04 - down);
  pins[{36, 0}] = on_skin(who, {0, -5.50 - down, 7.75 + who.form.chin_forward});
}

/// Where the ear grows out of the head: a drop, tilted back.
void pin_ear_border(const Identity& who, Pins& pins) {
  const std::vector<GridNode> border = border_of(kEarBlock);
  for (std::size_t i = 0; i < border.size(); ++i) {
    const double angle = radians(120 - static_cast<double>(i) * 360 / kEarSpokes);
    const double up = 1.75 * std::sin(angle);
    double back = 0.80 * std::cos(angle);
    back *= back < 0 ? 1.25 : up < 0 ? 0.8 : 1.0;
    constexpr double kTilt = 0.18;
    const double z = 1.15 - (back * std::cos(kTilt) + up * std::sin(kTilt));
    const double y = 1.15 + (up * std::cos(kTilt) - back * std::sin(kTilt) * 0.3);
    pins[{border[i].row, border[i].column}] = leave({0, y, z}, {1, 0, 0}, head_of(who));
  }
}

void add_grid(LayoutBuilder& builder) {
  const Identity& who = builder.who();
  Pins pins;
  pin_eye_border(who, pins);
  pin_nose(who, pins);
  pin_bridge(who, pins);
  pin_mouth_border(who, pins);
  pin_chin(who, pins);
  pin_ear_border(who, pins);
  const auto in_block = [](auto&& test) {
    return std::any_of(kBlocks.begin(), kBlocks.end(), test);
  };
  for (int row = 0; row <= kRows; ++row) {
    for (int column = 0; column <= kColumns; ++column) {
      if (in_block([&](const Block& b) { return b.has_inner_node(row, column); })) continue;
      const auto pin = pins.find({row, column});
      const bool pinned = pin != pins.end();
      builder.add_node(pinned ? pin->second : start_position(who, row, column), {row, column},
                       pinned || row == kRows);
    }
  }
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      if (in_block([&](const Block& b) { return b.has_cell(row, column); })) continue;
      builder.add_quad({builder.node(row, column), builder.node(row + 1, column),
                        builder.node(row + 1, column + 1), builder.node(row, column + 1)});
    }
  }
}

/// Half a disc of 8 x 16 quads over the crown; three of its sides are row 0 of the grid.
void add_cap(LayoutBuilder& builder) {
  const Identity& who = builder.who();
  constexpr int kAcross = 8;
  constexpr int kAlong = 16;
  std::array<std::array<std::uint32_t, kAlong + 1>, kAcross + 1> cap{};
  const auto at = [&](int i, int j) -> std::uint32_t& {
    return cap[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  };
  for (int c = 0; c <= 8; ++c) at(c, 0) = builder.node(0, c);
  for (int c = 8; c <= 24; ++c) at(kAcross, c - 8) = builder.node(0, c);
  for (int c = 24; c <= 32; ++c) at(32 - c, kAlong) = builder.node(0, c);
  for (int i = 0; i < kAcross; ++i) {
    for (int j = 1; j < kAlong; ++j) {
      const double u = static_cast<double>(i) / kAcross;
      const double t = static_cast<double>(j) / kAlong;
      const Vec3 front = builder.position(at(i, 0));
      const Vec3 back = builder.position(at(i, kAlong));
      const Vec3 side = builder.position(at(kAcross, j));
      const Vec3 flat{u * side.x * (0.5 + 0.5 * std::sin(kPi * t)), 9.5, mix(front.z, back.z, t)};
      constexpr Vec3 kInside{0, 4.5, 1.2};
      Vec3 p = leave(kInside, flat - kInside, head_of(who));
      if (i == 0) p.x = 0;
      at(i, j) = builder.add(p, Patch::Cap);
      builder.vertex(at(i, j)).pinned = false;
    }
  }
  for (int i = 0; i < kAcross; ++i) {
    for (int j = 0; j < kAlong; ++j) {
      builder.add_quad({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
}

}  // namespace

std::vector<GridNode> border_of(const Block& block) {
  std::vector<GridNode> border;
  for (int c = block.column_begin; c < block.column_end; ++c)
    border.push_back({block.row_begin, c});
  for (int r = block.row_begin; r < block.row_end; ++r) border.push_back({r, block.column_end});
  for (int c = block.column_end; c > block.column_begin; --c) border.push_back({block.row_end, c});
  if (block.column_begin == 0) {
    border.push_back({block.row_end, 0});
    return border;
  }
  for (int r = block.row_end; r > block.row_begin; --r) border.push_back({r, block.column_begin});
  return border;
}

std::uint32_t LayoutBuilder::add(const Vec3& position, Patch patch, int ring, int spoke) {
  HalfVertex vertex;
  vertex.position = position;
  vertex.patch = patch;
  vertex.ring = ring;
  vertex.spoke = spoke;
  vertex.pinned = true;
  vertex.on_midline = std::abs(position.x) < 1e-6;
  half_.vertices.push_back(vertex);
  return static_cast<std::uint32_t>(half_.vertices.size() - 1);
}

std::uint32_t LayoutBuilder::add_node(const Vec3& position, GridNode node, bool pinned) {
  const std::uint32_t index = add(position, Patch::Grid);
  HalfVertex& vertex = half_.vertices[index];
  vertex.row = node.row;
  vertex.column = node.column;
  vertex.pinned = pinned;
  vertex.on_midline = node.column == 0 || node.column == kColumns;
  if (vertex.on_midline) vertex.position.x = 0;
  grid_[static_cast<std::size_t>(node.row)][static_cast<std::size_t>(node.column)] = index;
  return index;
}

void LayoutBuilder::add_strip(const Ring& outer, const Ring& inner, bool closed) {
  const std::size_t n = outer.size();
  for (std::size_t i = 0; i < (closed ? n : n - 1); ++i) {
    const std::size_t next = (i + 1) % n;
    add_quad({outer[i], inner[i], inner[next], outer[next]});
  }
}

void LayoutBuilder::add_lid(const Ring& ring, std::uint32_t middle) {
  for (std::size_t i = 0; i < ring.size(); i += 2) {
    add_quad({ring[i], middle, ring[(i + 2) % ring.size()], ring[i + 1]});
  }
}

LayoutBuilder::Ring LayoutBuilder::nodes(const std::vector<GridNode>& of) const {
  Ring ring;
  for (const GridNode& n : of) ring.push_back(node(n.row, n.column));
  return ring;
}

HalfHead lay_out_half_head(const Identity& who) {
  LayoutBuilder builder(who);
  add_grid(builder);
  add_cap(builder);
  add_eye_patch(builder);
  add_mouth_patch(builder);
  add_nostril_patch(builder);
  add_ear_patch(builder);
  return builder.take();
}

}  // namespace aucast::facegen
