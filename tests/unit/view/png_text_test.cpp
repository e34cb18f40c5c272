#include "client/view/png_text.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "client/view/image.h"
#include "common/files.h"
#include "tests/support/temp_folder.h"

namespace aucast::view {
namespace {

struct Chunk {
  std::string type;
  std::string data;
};

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number = number << 8U | static_cast<unsigned char>(bytes.at(at + i));
  }
  return number;
}

/// The chunks of a PNG; each check sum is looked at.
std::vector<Chunk> chunks_of(const std::string& png) {
  std::vector<Chunk> chunks;
  for (std::size_t at = 8; at < png.size();) {
    const std::size_t length = number_at(png, at);
    const std::string typed = png.substr(at + 4, 4 + length);
    EXPECT_EQ(number_at(png, at + 8 + length), crc32(typed)) << typed.substr(0, 4);
    chunks.push_back({typed.substr(0, 4), typed.substr(4)});
    at += 12 + length;
  }
  return chunks;
}

TEST(Crc32, IsThatOfTheStandard) {
  EXPECT_EQ(crc32("123456789"), 0xCBF43926U);
  EXPECT_EQ(crc32(""), 0U);
  EXPECT_EQ(crc32("IEND"), 0xAE426082U);
}

TEST(PngText, StandsBehindTheHeaderAndLeavesThePictureAlone) {
  const test::TempFolder folder;
  const auto file = folder.path() / "x.png";
  const Image image = make_image(5, 3, 0x204060);
  const std::array<PngText, 2> texts{{{"Software", "AUcast"}, {"Face", "J\xC3\xBCrgen"}}};
  ASSERT_TRUE(write_png(image, file, texts));
  const auto bytes = read_file(file);
  ASSERT_TRUE(bytes.has_value());
  const auto chunks = chunks_of(*bytes);
  ASSERT_GE(chunks.size(), 5U);
  EXPECT_EQ(chunks[0].type, "IHDR");
  EXPECT_EQ(chunks[1].type, "iTXt");
  EXPECT_EQ(chunks[1].data, std::string("Software\0\0\0\0\0AUcast", 19));
  EXPECT_EQ(chunks[2].data, std::string("Face\0\0\0\0\0J\xC3\xBCrgen", 16));
  EXPECT_EQ(chunks[3].type, "IDAT");
  EXPECT_EQ(chunks.back().type, "IEND");
  const auto back = read_png(file);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->rgba, image.rgba);
}

}  // namespace
}  // namespace aucast::view
