#include "client/face/ply.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "tests/unit/face/small_face.h"

namespace aucast::face {
namespace {

using test::replaced;

/// Two parts: a skin quad and triangle, an eye triangle; one mask.
FaceMesh small_mesh() {
  FaceMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                    {2, 2, 0}, {5, 0, 1}, {6, 0, 1}, {5, 1, 1}};
  mesh.parts = {{"skin", Material::Skin, 0, 5, 0, 3}, {"left_eye", Material::Eye, 5, 3, 3, 1}};
  mesh.colours.assign(8, {0.5F, 0.25F, 0.125F, 1.0F});
  mesh.occlusion.assign(8, 0.75F);
  mesh.gloss.assign(8, 2.0F);
  mesh.maps["jaw"] = {0, 0.25F, 0.5F, 1, 0, 0, 0, 0};
  return mesh;
}

const std::vector<Polygon> kPolygons = {{{0, 1, 2, 3}, 4}, {{5, 6, 7, 0}, 3}, {{2, 4, 3, 0}, 3}};

std::string small_file() {
  return format_ply(small_mesh(), kPolygons);
}

std::string error_of(std::string_view bytes) {
  const auto mesh = parse_ply(bytes, "m.ply");
  EXPECT_FALSE(mesh.has_value());
  if (mesh.has_value()) return {};
  EXPECT_EQ(mesh.error().kind, ErrorKind::BadData);
  return mesh.error().message;
}

/// The file with four bytes of its body changed; counted from the end of the header.
std::string patched(std::size_t position, std::uint32_t value) {
  std::string bytes = small_file();
  const std::size_t body = bytes.find("end_header\n") + 11;
  std::memcpy(bytes.data() + body + position, &value, sizeof value);
  return bytes;
}

constexpr std::size_t kRecordBytes = 12 + 5 + 3 * 4;
constexpr std::uint32_t kNan = 0x7fc00000;

TEST(Ply, ReadsBackWhatItWrites) {
  const FaceMesh written = small_mesh();
  const auto read = parse_ply(small_file(), "m.ply");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_EQ(read->positions, written.positions);
  EXPECT_EQ(read->maps, written.maps);
  EXPECT_EQ(read->occlusion, written.occlusion);
  EXPECT_EQ(read->gloss, written.gloss);
  ASSERT_EQ(read->parts.size(), 2U);
  EXPECT_EQ(read->parts[1].name, "left_eye");
  EXPECT_EQ(read->parts[1].material, Material::Eye);
  EXPECT_EQ(read->parts[1].vertex_begin, 5U);
  EXPECT_EQ(read->parts[1].vertex_count, 3U);
  for (int channel = 0; channel < 4; ++channel) {
    EXPECT_NEAR(read->colours[3][channel], written.colours[3][channel], 0.004F);
  }
}

TEST(Ply, EveryMaterialKeepsItsName) {
  for (const std::string_view name : kMaterialNames) {
    FaceMesh written = small_mesh();
    written.parts[1].material = static_cast<Material>(
        std::find(kMaterialNames.begin(), kMaterialNames.end(), name) - kMaterialNames.begin());
    const std::string bytes = format_ply(written, kPolygons);
    EXPECT_NE(bytes.find("comment part left_eye " + std::string(name) + "\n"), std::string::npos);
    const auto read = parse_ply(bytes, "m.ply");
    ASSERT_TRUE(read.has_value()) << read.error().message;
    EXPECT_EQ(read->parts[1].material, written.parts[1].material) << name;
  }
  EXPECT_EQ(name(Material::GreyHair), "grey_hair");
  EXPECT_EQ(name(Material::Crease), "crease");
}

TEST(Ply, SplitsQuadsAndSortsTrianglesByPart) {
  const auto mesh = parse_ply(small_file(), "m.ply");
  ASSERT_TRUE(mesh.has_value());
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  EXPECT_EQ(mesh->triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {2, 4, 3}, {5, 6, 7}}));
  EXPECT_EQ(mesh->parts[0].triangle_count, 3U);
  EXPECT_EQ(mesh->parts[1].triangle_begin, 3U);
  EXPECT_EQ(mesh->parts[1].triangle_count, 1U);
}

TEST(Ply, EveryColourStepSurvives) {
  FaceMesh mesh;
  mesh.parts = {{"skin", Material::Skin, 0, 256, 0, 0}};
  mesh.positions.resize(256);
  mesh.colours.resize(256);
  std::string bytes = format_ply(mesh, {});
  const std::size_t body = bytes.find("end_header\n") + 11;
  for (std::size_t i = 0; i < 256; ++i) {
    for (std::size_t c = 0; c < 4; ++c) bytes[body + i * 17 + 12 + c] = static_cast<char>(i);
  }
  const auto read = parse_ply(bytes, "m.ply");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_EQ(format_ply(*read, {}).substr(format_ply(*read, {}).find("end_header")).size(),
            bytes.substr(bytes.find("end_header")).size() + 256 * 8);
  FaceMesh bare = *read;
  bare.occlusion.clear();
  bare.gloss.clear();
  EXPECT_EQ(format_ply(bare, {}), bytes);
}

TEST(Ply, MissingLightMapsAreOne) {
  FaceMesh mesh = small_mesh();
  mesh.occlusion.clear();
  mesh.gloss.clear();
  const auto read = parse_ply(format_ply(mesh, kPolygons), "m.ply");
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->occlusion, std::vector<float>(8, 1.0F));
  EXPECT_EQ(read->gloss, std::vector<float>(8, 1.0F));
}

TEST(Ply, HeaderErrorsNameTheLine) {
  const std::string good = small_file();
  EXPECT_EQ(error_of("hello\n"), "m.ply:1: this is no PLY file: its first line is not 'ply'");
  EXPECT_EQ(error_of(""), "m.ply: the header does not end with end_header");
  EXPECT_EQ(error_of(replaced(good, "binary_little_endian", "ascii")),
            "m.ply:2: the format must be 'binary_little_endian 1.0'");
  EXPECT_EQ(error_of(replaced(good, "format binary_little_endian 1.0\n", "")),
            "m.ply:18: there is no format line");
  EXPECT_EQ(error_of(replaced(good, "left_eye eye", "left_eye eyes")),
            "m.ply:4: unknown material 'eyes'; did you mean eye?");
  EXPECT_EQ(error_of(replaced(good, "part skin", "part nose")),
            "m.ply:3: the first part must be skin");
  EXPECT_EQ(error_of(replaced(good, "part left_eye", "part skin")),
            "m.ply:4: part 'skin' is there twice");
  EXPECT_EQ(error_of(replaced(good, "vertex 8", "vertex 1000001")),
            "m.ply:5: more than 1000000 vertices");
  EXPECT_EQ(error_of(replaced(good, "vertex 8", "vertex x8")), "m.ply:5: 'x8' is no count");
  EXPECT_EQ(error_of(replaced(good, "face 3", "face 2000001")),
            "m.ply:17: more than 2000000 polygons");
  EXPECT_EQ(error_of(replaced(good, "float jaw", "double jaw")),
            "m.ply:16: property jaw must be float");
  EXPECT_EQ(error_of(replaced(good, "float jaw", "float gloss")),
            "m.ply:16: property gloss is there twice");
  EXPECT_EQ(error_of(replaced(good, "property uchar part\n", "")),
            "m.ply:18: vertices have no property part");
  EXPECT_EQ(error_of(replaced(good, "list uchar uint", "list uchar short")),
            "m.ply:18: faces have exactly the property 'list uchar uint vertex_indices'");
  EXPECT_EQ(error_of(replaced(good, "property list uchar uint vertex_indices\n", "")),
            "m.ply:18: the elements vertex and face with their properties must come before "
            "end_header");
  EXPECT_EQ(error_of(replaced(good, "element vertex", "elements vertex")),
            "m.ply:5: unknown header line 'elements'");
  EXPECT_EQ(error_of(replaced(good, "element face", "element edge")),
            "m.ply:17: the elements must be 'vertex N' and then 'face N', once each");
}

/// A mesh of so many parts, of one vertex each, and so many masks.
FaceMesh mesh_with(std::size_t parts, std::size_t masks) {
  FaceMesh mesh;
  mesh.positions.resize(parts);
  mesh.colours.resize(parts);
  for (std::size_t i = 0; i < parts; ++i) {
    mesh.parts.push_back({i == 0 ? "skin" : "part" + std::to_string(i), Material::Skin,
                          static_cast<std::uint32_t>(i), 1, 0, 0});
  }
  for (std::size_t i = 0; i < masks; ++i) {
    mesh.maps["mask" + std::to_string(i)].resize(parts);
  }
  return mesh;
}

TEST(Ply, LimitsHoldToTheLastThatIsAllowed) {
  constexpr std::size_t kFixed = 8;  // x, y, z, four of colour, part
  const std::string most = format_ply(mesh_with(kPlyPartsMax, kPlyPropertiesMax - kFixed), {});
  const auto mesh = parse_ply(most, "m.ply");
  ASSERT_TRUE(mesh.has_value()) << mesh.error().message;
  EXPECT_EQ(mesh->parts.size(), kPlyPartsMax);
  EXPECT_EQ(mesh->maps.size(), kPlyPropertiesMax - kFixed);
  EXPECT_EQ(error_of(replaced(most, "element vertex", "comment part hat hair\nelement vertex")),
            "m.ply:67: more than 64 parts");
  EXPECT_EQ(error_of(format_ply(mesh_with(1, kPlyPropertiesMax + 1 - kFixed), {})),
            "m.ply:105: more than 100 properties");
  const std::string long_line = "comment " + std::string(64 * 1024, 'x') + "\n";
  EXPECT_EQ(error_of(replaced(small_file(), "element vertex", long_line + "element vertex")),
            "m.ply:4: the header does not end with end_header");
}

TEST(Ply, APolygonMayBeMissingAndAFileMayHaveNone) {
  const auto mesh = parse_ply(format_ply(small_mesh(), {}), "m.ply");
  ASSERT_TRUE(mesh.has_value()) << mesh.error().message;
  EXPECT_TRUE(mesh->triangles.empty());
  EXPECT_EQ(mesh->parts[1].triangle_count, 0U);
}

TEST(Ply, MapsKeepTheirOwnRanges) {
  const std::pair<const char*, std::pair<float, float>> ranges[] = {
      {"muscle", {0, 1}},
      {"head", {0, 1}},
      {"lid_angle", {-1.5707964F, 1.5707964F}},
      {"root_below", {-1, 1}},
      {"anything", {-1e6F, 1e6F}}};
  for (const auto& [map, range] : ranges) {
    for (const float value : {range.first, range.second}) {
      FaceMesh mesh = small_mesh();
      mesh.maps[map].assign(8, value);
      EXPECT_TRUE(parse_ply(format_ply(mesh, kPolygons), "m.ply").has_value()) << map << value;
      if (std::string(map) == "anything") continue;
      mesh.maps[map][7] = value + (value > 0 ? 0.01F : -0.01F);
      EXPECT_NE(error_of(format_ply(mesh, kPolygons)).find("vertex 7: " + std::string(map)),
                std::string::npos);
    }
  }
}

TEST(Ply, BodyErrorsNameVertexOrPolygon) {
  EXPECT_EQ(error_of(patched(3 * kRecordBytes + 4, kNan)),
            "m.ply: vertex 3: y is not a finite number");
  EXPECT_EQ(error_of(patched(2 * kRecordBytes + 12 + 5 + 8, kNan)),
            "m.ply: vertex 2: jaw is not a finite number");
  EXPECT_EQ(error_of(patched(2 * kRecordBytes + 12 + 5 + 8, 0x40000000)),
            "m.ply: vertex 2: jaw is 2.000000, outside 0.000000 to 1.000000");
  EXPECT_EQ(error_of(patched(8 * kRecordBytes + 1 + 4, 8)),
            "m.ply: polygon 0: there is no vertex 8");
  EXPECT_EQ(error_of(patched(8 * kRecordBytes + 1 + 4, 6)),
            "m.ply: polygon 0: it joins the parts skin and left_eye");
  std::string five = small_file();
  five[five.find("end_header\n") + 11 + 8 * kRecordBytes] = 5;
  EXPECT_EQ(error_of(five), "m.ply: polygon 0: it has 5 corners, not 3 or 4");
  std::string other_part = small_file();
  const std::size_t part_byte = other_part.find("end_header\n") + 11 + 16;
  other_part[part_byte] = 7;
  EXPECT_EQ(error_of(other_part), "m.ply: vertex 0: there is no part 7");
  other_part[part_byte] = 1;
  EXPECT_EQ(error_of(other_part),
            "m.ply: vertex 1: the vertices of part skin do not stand together in the parts' order");
  EXPECT_EQ(
      error_of(replaced(small_file(), "element vertex", "comment part hat hair\nelement vertex")),
      "m.ply: part hat has no vertices");
}

TEST(Ply, AFileCutAtAnyByteIsAnError) {
  const std::string good = small_file();
  for (std::size_t length = 0; length < good.size(); ++length) {
    EXPECT_FALSE(parse_ply(std::string_view(good).substr(0, length), "m.ply").has_value())
        << length;
  }
  EXPECT_EQ(error_of(good + "x"), "m.ply: there are bytes after the last polygon");
}

}  // namespace
}  // namespace aucast::face
