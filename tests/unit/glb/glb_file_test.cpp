#include "client/glb/glb_file.h"

#include <cstring>

#include <gtest/gtest.h>

#include "tests/unit/glb/read_glb.h"

namespace aucast::glb {
namespace {

using test::ReadGlb;

TEST(GlbFile, HasBothChunksPaddedToFourBytes) {
  for (std::size_t length = 1; length <= 5; ++length) {
    GlbFile file;
    file.document()["asset"]["generator"] = std::string(length, 'x');
    EXPECT_EQ(file.morph_weights(std::vector<std::uint8_t>(length, 7)), 0);
    const ReadGlb parts(file.bytes());
    EXPECT_EQ(parts.document["buffers"][0]["byteLength"], parts.binary.size());
    EXPECT_EQ(parts.document["bufferViews"][0]["byteLength"], length);
  }
}

TEST(GlbFile, ANameThatIsNoUtf8GetsReplacementCharacters) {
  GlbFile file;
  file.document()["asset"]["generator"] = "caf\xE9";
  const ReadGlb parts(file.bytes());
  EXPECT_EQ(parts.document["asset"]["generator"], "caf\uFFFD");
}

TEST(GlbFile, APositionsRangeIsThatOfItsNumbers) {
  GlbFile file;
  EXPECT_EQ(file.positions(std::vector<glm::vec3>{{1, -2, 3}, {-1, 0.1F, 5}}), 0);
  const ReadGlb parts(file.bytes());
  EXPECT_EQ(parts.document["accessors"][0]["min"], (Json{-1.0, -2.0, 3.0}));
  EXPECT_EQ(parts.document["accessors"][0]["max"][1].get<float>(), 0.1F);
}

TEST(GlbFile, ChangesAreSparseAndTheirRangeHasTheZerosBetween) {
  GlbFile file;
  EXPECT_EQ(
      file.position_changes(std::vector<Change>{{2, {1, -0.5F, 0.25F, 0}}, {7, {2, 0, 0, 0}}}, 9),
      0);
  EXPECT_EQ(file.normal_changes(std::vector<Change>{{8, {0, 1, 0, 0}}}, 9), 1);
  const ReadGlb parts(file.bytes());
  const Json& first = parts.document["accessors"][0];
  EXPECT_FALSE(first.contains("bufferView"));
  EXPECT_EQ(first["count"], 9);
  EXPECT_EQ(first["sparse"]["count"], 2);
  EXPECT_EQ(first["componentType"], 5122);
  EXPECT_TRUE(first["normalized"]);
  EXPECT_EQ(first["min"], (Json{0, -16384, 0})) << "in steps of the file";
  EXPECT_EQ(first["max"], (Json{32767, 0, 8192}));
  const Json& second = parts.document["accessors"][1];
  EXPECT_EQ(second["sparse"]["indices"]["byteOffset"], 4);
  EXPECT_EQ(second["sparse"]["values"]["byteOffset"], 12);
  const std::size_t view = second["sparse"]["indices"]["bufferView"];
  const std::size_t begin = parts.document["bufferViews"][view]["byteOffset"];
  EXPECT_EQ(parts.binary[begin + 4], 8);
  EXPECT_EQ(second["componentType"], 5120);
  const std::size_t values = second["sparse"]["values"]["bufferView"];
  const std::size_t at =
      parts.document["bufferViews"][values]["byteOffset"].get<std::size_t>() + 12;
  EXPECT_EQ(parts.binary.substr(at, 3), std::string("\0\x7f\0", 3));
}

TEST(GlbFile, APositionsChangeIsRoundedAsItIsStored) {
  const glm::vec3 stored = stored_position_change({0.1F, -0.00001F, 0});
  EXPECT_FLOAT_EQ(stored.x, 3277.0F / 32767);
  EXPECT_EQ(stored.y, 0);
  EXPECT_EQ(stored_position_change(stored), stored);
}

TEST(GlbFile, NoChangesAreAnAccessorOfZerosWithoutBytes) {
  GlbFile file;
  EXPECT_EQ(file.position_changes({}, 5), 0);
  const ReadGlb parts(file.bytes());
  EXPECT_FALSE(parts.document["accessors"][0].contains("sparse")) << "a count of 0 is not allowed";
  EXPECT_EQ(parts.document["accessors"][0]["max"], (Json{0, 0, 0}));
}

TEST(GlbFile, AllThatChangeNothingShareTheirZeros) {
  GlbFile file;
  EXPECT_EQ(file.position_changes({}, 5), 0);
  EXPECT_EQ(file.position_changes(std::vector<Change>{{1, {1, 0, 0, 0}}}, 5), 1);
  EXPECT_EQ(file.position_changes({}, 5), 0);
  EXPECT_EQ(file.normal_changes({}, 5), 2) << "of another type";
  EXPECT_EQ(file.position_changes({}, 6), 3) << "of another mesh";
  EXPECT_EQ(file.normal_changes({}, 5), 2);
  const ReadGlb read(file.bytes());
  ASSERT_EQ(read.document["accessors"].size(), 4U);
  EXPECT_EQ(read.document["accessors"][1]["max"], (Json{32'767, 0, 0}));
  EXPECT_EQ(read.rows(std::size_t{3}), ReadGlb::Rows(6, {0, 0, 0}));
}

TEST(GlbFile, IndicesOfManyVerticesAreWide) {
  GlbFile file;
  const std::vector<std::array<std::uint32_t, 3>> triangle{{0, 1, 2}};
  EXPECT_EQ(file.triangles(triangle, 65'535), 0);
  EXPECT_EQ(file.triangles(triangle, 65'536), 1);
  EXPECT_EQ(file.position_changes(std::vector<Change>{{65'535, {1, 0, 0, 0}}}, 65'536), 2);
  const ReadGlb parts(file.bytes());
  EXPECT_EQ(parts.document["accessors"][0]["componentType"], 5123);
  EXPECT_EQ(parts.document["accessors"][1]["componentType"], 5125);
  EXPECT_EQ(parts.document["accessors"][2]["sparse"]["indices"]["componentType"], 5125);
}

TEST(GlbFile, WeightsOfSixteenBitsStillSumToOne) {
  GlbFile file;
  EXPECT_EQ(file.joint_weights(std::vector<std::array<float, 4>>{{0.3333F, 0.3333F, 0.3334F, 0}}),
            0);
  const ReadGlb parts(file.bytes());
  int sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    std::uint16_t weight = 0;
    std::memcpy(&weight, parts.binary.data() + 2 * i, sizeof weight);
    sum += weight;
  }
  EXPECT_EQ(sum, 65'535);
}

TEST(GlbFile, ColoursAreClampedAndOfSixteenBits) {
  GlbFile file;
  EXPECT_EQ(file.colours(std::vector<glm::vec4>{{-1, 0.5F, 2, 1}}), 0);
  const ReadGlb read(file.bytes());
  const auto row = read.rows(std::size_t{0}).at(0);
  EXPECT_EQ(row[0], 0);
  EXPECT_NEAR(row[1], 0.5F, 1.0F / 65'535);
  EXPECT_EQ(row[2], 1) << "and does not begin anew at 0";
  EXPECT_EQ(row[3], 1);
}

TEST(GlbFile, NumbersOfEveryKindAreReadBack) {
  GlbFile file;
  const std::vector<glm::vec2> coordinates{{0.25F, -3}, {7, 0}};
  const std::vector<std::array<std::uint8_t, 4>> joints{{0, 1, 2, 255}};
  const std::vector<glm::quat> rotations{glm::quat(0.5F, 0.1F, 0.2F, 0.3F)};
  const std::vector<std::array<float, 16>> matrices{{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13}};
  const std::vector<float> times{0, 0.5F};
  EXPECT_EQ(file.texture_coordinates(coordinates), 0);
  EXPECT_EQ(file.joints(joints), 1);
  EXPECT_EQ(file.rotations(rotations), 2);
  EXPECT_EQ(file.translations(std::vector<glm::vec3>{{1, 2, 3}}), 3);
  EXPECT_EQ(file.inverse_bind_matrices(matrices), 4);
  EXPECT_EQ(file.sample_times(times), 5);
  EXPECT_EQ(file.morph_weights(std::vector<std::uint8_t>{0, 51, 255}), 6);
  const ReadGlb read(file.bytes());
  const auto rows = [&read](std::size_t index) { return read.rows(index); };
  EXPECT_EQ(rows(0), (ReadGlb::Rows{{0.25F, -3}, {7, 0}}));
  EXPECT_EQ(rows(1), (ReadGlb::Rows{{0, 1, 2, 255}}));
  EXPECT_EQ(rows(2), (ReadGlb::Rows{{0.1F, 0.2F, 0.3F, 0.5F}})) << "x, y, z, then w";
  EXPECT_EQ(rows(3), (ReadGlb::Rows{{1, 2, 3}}));
  EXPECT_EQ(rows(4).at(0).at(12), 13);
  EXPECT_EQ(rows(5), (ReadGlb::Rows{{0}, {0.5F}}));
  EXPECT_EQ(read.document["accessors"][5]["min"], Json{0.0});
  EXPECT_EQ(read.document["accessors"][5]["max"], Json{0.5});
  EXPECT_EQ(rows(6), (ReadGlb::Rows{{0}, {0.2F}, {1}}));
}

TEST(GlbFile, AChangeBeyondAMetreIsOneOfAMetre) {
  EXPECT_EQ(stored_position_change({5, -5, 1}), glm::vec3(1, -1, 1));
  GlbFile file;
  const std::vector<Change> far{{0, {5, -5, 0, 0}}};
  EXPECT_EQ(file.position_changes(far, 1), 0);
  const ReadGlb read(file.bytes());
  EXPECT_EQ(read.rows(std::size_t{0}), (ReadGlb::Rows{{1, -1, 0}}));
  EXPECT_EQ(read.document["accessors"][0]["min"], (Json{32'767, -32'767, 0}))
      << "there is no zero between: all vertices are changed";
}

TEST(GlbFile, ChangesOfManyTargetsAreEachReadBackFromTheViewsThatTheyShare) {
  GlbFile file;
  // Of three bytes, twelve and sixteen, so that each has to be put into line.
  const std::vector<Change> normals{{1, {1, 0, -1, 0}}};
  const std::vector<Change> positions{{0, {0.5F, 0, 0, 0}}, {2, {0, 0, -0.5F, 0}}};
  const std::vector<Change> colours{{2, {0, 0, 0, 0.75F}}};
  EXPECT_EQ(file.normal_changes(normals, 3), 0);
  EXPECT_EQ(file.position_changes(positions, 3), 1);
  EXPECT_EQ(file.normal_changes(normals, 3), 2);
  EXPECT_EQ(file.colour_changes(colours, 3), 3);
  const ReadGlb read(file.bytes());
  const ReadGlb::Rows turned{{0, 0, 0}, {1, 0, -1}, {0, 0, 0}};
  EXPECT_EQ(read.rows(std::size_t{0}), turned);
  EXPECT_EQ(read.rows(std::size_t{2}), turned);
  const ReadGlb::Rows moved = read.rows(std::size_t{1});
  EXPECT_NEAR(moved[0][0], 0.5F, 2e-5F);
  EXPECT_EQ(moved[1], (std::vector<float>{0, 0, 0}));
  EXPECT_NEAR(moved[2][2], -0.5F, 2e-5F);
  EXPECT_EQ(read.rows(std::size_t{3})[2], (std::vector<float>{0, 0, 0, 0.75F}));
}

TEST(GlbFile, APictureIsThereByteForByte) {
  GlbFile file;
  const std::string picture("\x89PNG\0 and more", 15);
  EXPECT_EQ(file.png(picture), 0);
  EXPECT_EQ(file.png("second"), 1);
  const ReadGlb read(file.bytes());
  const Json& view = read.document["bufferViews"][0];
  EXPECT_EQ(read.binary.substr(view["byteOffset"], view["byteLength"]), picture);
  EXPECT_EQ(read.document["images"][1]["bufferView"], 1);
  EXPECT_FALSE(view.contains("target")) << "it is no array of vertices";
}

}  // namespace
}  // namespace aucast::glb
