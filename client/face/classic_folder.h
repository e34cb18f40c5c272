#pragma once

#include <filesystem>

#include "client/face/face.h"
#include "common/result.h"

namespace aucast::face {

/// Reads a folder in Waters' classic format:
/// - faceline.dat: a count, then that many points "x y z" of half a face.
/// - index.dat: a count, then rows of four points, counted from 1; 1000 anywhere in a row marks a
///   triangle. The other half of the face is its mirror image; points with x = 0 belong to both.
/// - muscle.dat: a count, then for each muscle its name, its insertion, its attachment, and a line
///   of fall-off start, fall-off finish, zone in degrees and a clamp that Waters' program reads but
///   does not use. The names are kept as they are; side_at() decides the side, not the name.
/// - jaw.dat, optional: a count, then rows of a point and its weight from 0 to 1 (the point's
///   mirror image gets the same); the jaw turns by one degree per unit about the origin (thesis eq.
///   3.20).
///
/// Vertices are the points in order and then the mirrors of those with x != 0 in order. Muscles
/// follow Waters' released formula without a cap. `data_folder` holds faces/classic_aus.toml. Fails
/// with BadData and file:line:column, or with Unreadable if a file is missing.
[[nodiscard]] Result<Face> load_classic_folder(const std::filesystem::path& folder,
                                               const std::filesystem::path& data_folder);

}  // namespace aucast::face
