#include "tests/unit/face/small_face.h"

#include <gtest/gtest.h>

#include <cmath>

namespace aucast::face::test {
namespace {

constexpr int kColumns = 41;
constexpr int kRows = 41;
constexpr std::uint32_t kSkinCount = kColumns * kRows;
constexpr std::uint32_t kEyeVertices = 10;
constexpr float kEyeX = 2.2F;
constexpr float kEyeY = 2.7F;
constexpr float kEyeZ = 6.2F;

glm::vec3 skin_point(int row, int column) {
  // Halves and quarters only, so that x is exactly mirrored.
  const float x = 0.25F * static_cast<float>(column - kColumns / 2);
  const float y = 0.4F * static_cast<float>(row) - 7.5F;
  return {x, y, 8.8F - 0.12F * x * x - 0.02F * y * y};
}

}  // namespace

FaceMesh small_mesh() {
  FaceMesh mesh;
  std::vector<float> jaw;
  std::vector<float> head;
  std::vector<float> lid;
  std::vector<float> muscle;
  std::vector<float> half;
  const auto add = [&](const glm::vec3& p, bool skin) {
    mesh.positions.push_back(p);
    const bool near_eye = skin && std::abs(std::abs(p.x) - kEyeX) < 1 && std::abs(p.y - kEyeY) < 1;
    jaw.push_back(skin && p.y < -2.5F ? std::min(1.0F, (-2.5F - p.y) / 2) : 0.0F);
    head.push_back(skin ? std::clamp((p.y + 7) / 3, 0.0F, 1.0F) : 1.0F);
    lid.push_back(!near_eye ? 0.0F : p.y > kEyeY ? 0.5F : -0.1F);
    muscle.push_back(skin ? 1.0F : 0.0F);
    half.push_back(0.5F);
  };
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) add(skin_point(row, column), true);
  }
  for (const float side : {1.0F, -1.0F}) {
    for (std::uint32_t i = 0; i < kEyeVertices; ++i) {
      const float angle = 0.6F * static_cast<float>(i);
      add({side * (kEyeX + std::cos(angle)), kEyeY + std::sin(angle), kEyeZ + 0.3F}, false);
    }
  }
  mesh.parts = {{"skin", Material::Skin, 0, kSkinCount, 0, 0},
                {"left_eye", Material::Eye, kSkinCount, kEyeVertices, 0, 0},
                {"right_eye", Material::Eye, kSkinCount + kEyeVertices, kEyeVertices, 0, 0}};
  mesh.colours.assign(mesh.positions.size(), {0.5F, 0.4F, 0.3F, 1.0F});
  mesh.maps = {
      {"jaw", jaw}, {"head", head}, {"lid_angle", lid}, {"muscle", muscle}, {"half", half}};
  return mesh;
}

std::vector<Polygon> small_polygons() {
  std::vector<Polygon> polygons;
  const auto index = [](int row, int column) {
    return static_cast<std::uint32_t>(row * kColumns + column);
  };
  for (int row = 0; row + 1 < kRows; ++row) {
    for (int column = 0; column + 1 < kColumns; ++column) {
      polygons.push_back({{index(row, column), index(row, column + 1), index(row + 1, column + 1),
                           index(row + 1, column)},
                          4});
    }
  }
  for (const std::uint32_t begin : {kSkinCount, kSkinCount + kEyeVertices}) {
    for (std::uint32_t i = 1; i + 1 < kEyeVertices; ++i) {
      polygons.push_back({{begin, begin + i, begin + i + 1, 0}, 3});
    }
  }
  return polygons;
}

std::string small_face_toml() {
  return R"(format = 1
name = "small"
mesh = "mesh.ply"
muscles = "muscles.toml"
aus = "aus.toml"

[jaw]
hinge = [0.0, 0.9, 1.5]
degrees_per_unit = 5.5
forward_per_rad = 0.35

[lids]
raise_max = 0.2

[[eye]]
part = "left_eye"
centre = [2.2, 2.7, 6.2]

[[eye]]
part = "right_eye"
centre = [-2.2, 2.7, 6.2]

[head]
pivot = [0.0, -4.6, -0.6]
)";
}

std::string small_muscles_toml() {
  return R"([[muscle]]
name = "zygomaticus_major"
mirrored = true
kind = "linear"
attachment = [3.805, 0.868, 6.6]
insertion = [1.57, -2.221, 7.82]
zone_deg = 45.0
falloff_start = 0.1
falloff_finish = 4.8

[[muscle]]
name = "depressor"
mirrored = true
kind = "linear"
attachment = [2.559, -4.277, 5.351]
insertion = [1.57, -2.221, 8.025]
zone_deg = 65.0
falloff_start = 0.3
falloff_finish = 4.5
mask = "half"

[[muscle]]
name = "orbicularis_oris"
kind = "mouth_sphincter"
centre = [0.0, -2.35, 8.2]
semi_axes = [2.6, 1.9]
depth = 3.0

[[muscle]]
name = "orbicularis_oculi"
mirrored = true
kind = "eye_sphincter"
centre = [2.2, 2.72, 7.7]
semi_axes = [2.2, 1.9]
depth = 2.5

[[muscle]]
name = "frontalis_sheet"
mirrored = true
kind = "sheet"
attachment = [2.0, 6.8, 7.3]
insertion = [2.0, 3.4, 8.0]
width = 3.6
depth = 2.0

[[muscle]]
name = "mentalis"
kind = "pull"
centre = [0.0, -4.2, 8.3]
direction = [0.0, 0.35, 0.10]
radii = [1.2, 0.9, 1.5]
)";
}

std::string small_aus_toml() {
  return R"([[au]]
number = 12
drive = { zygomaticus_major = 1.5, left_depressor = 0.25 }
note = "corners up"

[[au]]
number = 15
drive = { depressor = 0.5 }

[[au]]
number = 26
drive = { jaw = 2.2 }

[[au]]
number = 6
drive = { lid_close = 0.25, orbicularis_oculi = 0.8 }

[[au]]
number = 43
drive = { lid_close = 1.0 }

[[au]]
number = 46
drive = { lid_close = 1.0 }

[[au]]
number = 51
drive = { head_turn_left = 1.0 }

[[au]]
number = 61
drive = { gaze_left = 1.0 }
)";
}

void write_small_face(const aucast::test::TempFolder& folder) {
  folder.write("face.toml", small_face_toml());
  folder.write("muscles.toml", small_muscles_toml());
  folder.write("aus.toml", small_aus_toml());
  folder.write("mesh.ply", format_ply(small_mesh(), small_polygons()));
}

Face small_face() {
  const aucast::test::TempFolder folder;
  write_small_face(folder);
  auto face = load_face(folder.path(), folder.path());
  EXPECT_TRUE(face.has_value()) << (face.has_value() ? "" : face.error().message);
  return face.has_value() ? *std::move(face) : Face{};
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::vector<float> only(const Face& face, std::string_view channel, float value) {
  std::vector<float> activations(face.channels.size(), 0.0F);
  const auto index = face.channel_index(channel);
  EXPECT_TRUE(index.has_value()) << channel;
  if (index) activations[*index] = value;
  return activations;
}

}  // namespace aucast::face::test
