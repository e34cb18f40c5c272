#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "client/face/face_mesh.h"
#include "common/result.h"

namespace aucast::face {

/// One face of the mesh (in the sense of PLY): three or four vertices, counter-clockwise from
/// outside.
struct Polygon {
  std::array<std::uint32_t, 4> corners{};
  std::uint8_t corner_count = 4;  ///< 3 or 4; with 3 the last corner is unused
};

/// The limits of a mesh file. They are far above what any face needs and keep a broken file from
/// filling the memory.
inline constexpr std::size_t kPlyVerticesMax = 1'000'000;
inline constexpr std::size_t kPlyPolygonsMax = 2'000'000;
inline constexpr std::size_t kPlyPropertiesMax = 100;  ///< per vertex
inline constexpr std::size_t kPlyPartsMax = 64;

/// Reads the bytes of a mesh.ply (data/faces/FORMAT.md). Quads become two triangles along the
/// diagonal from their first corner; triangles are sorted by part and otherwise keep the file's
/// order. `maps` gets the file's maps; `occlusion` and `gloss` are filled with 1 if the file has
/// none. Fails with BadData and a message that names `file` and the line of the header, the vertex
/// or the polygon. Vertices and polygons are counted from 0.
[[nodiscard]] Result<FaceMesh> parse_ply(std::string_view bytes, std::string_view file);

/// The bytes of a mesh.ply. parse_ply() reads the same mesh back: colours to the nearest of 256
/// sRGB steps, all else bit for bit. `polygons` are written in place of mesh.triangles, which are
/// ignored. The mesh must be sound: every array must have one entry per vertex (occlusion and gloss
/// may be empty), and the parts must cover the vertices in order.
[[nodiscard]] std::string format_ply(const FaceMesh& mesh, std::span<const Polygon> polygons);

}  // namespace aucast::face
