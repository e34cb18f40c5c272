#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/face/face.h"
#include "client/face/ply.h"
#include "tests/support/temp_folder.h"

namespace aucast::face::test {

/// A curved grid of skin, symmetric in x to the last bit, with two little eyes and all maps: 1,701
/// vertices in Waters' frame, enough for every muscle kind to have something to move.
[[nodiscard]] FaceMesh small_mesh();
[[nodiscard]] std::vector<Polygon> small_polygons();

// The files of the small face; tests write changed copies of them.
[[nodiscard]] std::string small_face_toml();
[[nodiscard]] std::string small_muscles_toml();
[[nodiscard]] std::string small_aus_toml();

/// Writes the four files.
void write_small_face(const aucast::test::TempFolder& folder);

/// The small face, loaded from a folder of its own.
[[nodiscard]] Face small_face();

/// `text` with the first `from` replaced by `to`; fails the test when there is none.
[[nodiscard]] std::string replaced(std::string text, std::string_view from, std::string_view to);

/// One activation per channel: `value` for the named one, 0 for the others.
[[nodiscard]] std::vector<float> only(const Face& face, std::string_view channel, float value);

}  // namespace aucast::face::test
