#include "client/glb/glb_file.h"

#include <cstring>

#include <gtest/gtest.h>

namespace aucast::glb {
namespace {

std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

struct Parts {
  Json document;
  std::string binary;
};

/// Checks the header and the chunks' lengths on the way.
Parts taken_apart(const std::string& bytes) {
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(word(bytes, 4), 2U);
  EXPECT_EQ(word(bytes, 8), bytes.size());
  const std::size_t json = word(bytes, 12);
  EXPECT_EQ(json % 4, 0U);
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  const std::size_t binary = word(bytes, 20 + json);
  EXPECT_EQ(binary % 4, 0U);
  EXPECT_EQ(bytes.substr(24 + json, 4), std::string("BIN\0", 4));
  EXPECT_EQ(bytes.size(), 28 + json + binary);
  return {Json::parse(bytes.substr(20, json)), bytes.substr(28 + json)};
}

TEST(GlbFile, HasBothChunksPaddedToFourBytes) {
  for (std::size_t length = 1; length <= 5; ++length) {
    GlbFile file;
    file.document()["asset"]["generator"] = std::string(length, 'x');
    EXPECT_EQ(file.weights(std::vector<std::uint8_t>(length, 7)), 0);
    const Parts parts = taken_apart(file.bytes());
    EXPECT_EQ(parts.document["buffers"][0]["byteLength"], parts.binary.size());
    EXPECT_EQ(parts.document["bufferViews"][0]["byteLength"], length);
  }
}

TEST(GlbFile, ANameThatIsNoUtf8GetsReplacementCharacters) {
  GlbFile file;
  file.document()["asset"]["generator"] = "caf\xE9";
  const Parts parts = taken_apart(file.bytes());
  EXPECT_EQ(parts.document["asset"]["generator"], "caf\uFFFD");
}

TEST(GlbFile, APlacesRangeIsThatOfItsNumbers) {
  GlbFile file;
  EXPECT_EQ(file.places(std::vector<glm::vec3>{{1, -2, 3}, {-1, 0.1F, 5}}), 0);
  const Parts parts = taken_apart(file.bytes());
  EXPECT_EQ(parts.document["accessors"][0]["min"], (Json{-1.0, -2.0, 3.0}));
  EXPECT_EQ(parts.document["accessors"][0]["max"][1].get<float>(), 0.1F);
}

TEST(GlbFile, ChangesAreSparseAndTheirRangeHasTheZerosBetween) {
  GlbFile file;
  EXPECT_EQ(
      file.place_changes(std::vector<Change>{{2, {1, -0.5F, 0.25F, 0}}, {7, {2, 0, 0, 0}}}, 9), 0);
  EXPECT_EQ(file.normal_changes(std::vector<Change>{{8, {0, 1, 0, 0}}}, 9), 1);
  const Parts parts = taken_apart(file.bytes());
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

TEST(GlbFile, APlacesChangeIsRoundedAsItIsStored) {
  const glm::vec3 stored = stored_place_change({0.1F, -0.00001F, 0});
  EXPECT_FLOAT_EQ(stored.x, 3277.0F / 32767);
  EXPECT_EQ(stored.y, 0);
  EXPECT_EQ(stored_place_change(stored), stored);
}

TEST(GlbFile, NoChangesAreAnAccessorOfZerosWithoutBytes) {
  GlbFile file;
  EXPECT_EQ(file.place_changes({}, 5), 0);
  const Parts parts = taken_apart(file.bytes());
  EXPECT_FALSE(parts.document["accessors"][0].contains("sparse")) << "a count of 0 is not allowed";
  EXPECT_EQ(parts.document["accessors"][0]["max"], (Json{0, 0, 0}));
}

TEST(GlbFile, IndicesOfManyVerticesAreWide) {
  GlbFile file;
  const std::vector<std::array<std::uint32_t, 3>> triangle{{0, 1, 2}};
  EXPECT_EQ(file.triangles(triangle, 65'535), 0);
  EXPECT_EQ(file.triangles(triangle, 65'536), 1);
  EXPECT_EQ(file.place_changes(std::vector<Change>{{65'535, {1, 0, 0, 0}}}, 65'536), 2);
  const Parts parts = taken_apart(file.bytes());
  EXPECT_EQ(parts.document["accessors"][0]["componentType"], 5123);
  EXPECT_EQ(parts.document["accessors"][1]["componentType"], 5125);
  EXPECT_EQ(parts.document["accessors"][2]["sparse"]["indices"]["componentType"], 5125);
}

TEST(GlbFile, SharesOfSixteenBitsStillSumToOne) {
  GlbFile file;
  EXPECT_EQ(file.shares(std::vector<std::array<float, 4>>{{0.3333F, 0.3333F, 0.3334F, 0}}), 0);
  const Parts parts = taken_apart(file.bytes());
  int sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    std::uint16_t share = 0;
    std::memcpy(&share, parts.binary.data() + 2 * i, sizeof share);
    sum += share;
  }
  EXPECT_EQ(sum, 65'535);
}

}  // namespace
}  // namespace aucast::glb
