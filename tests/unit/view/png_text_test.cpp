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
  const std::array<PngText, 3> texts{
      {{"Software", "AUcast"}, {"Face", "J\xC3\xBCrgen"}, {"Edited", "\xC5\x81ukasz"}}};
  ASSERT_TRUE(write_png(image, file, texts));
  const auto bytes = read_file(file);
  ASSERT_TRUE(bytes.has_value());
  const auto chunks = chunks_of(*bytes);
  ASSERT_GE(chunks.size(), 6U);
  EXPECT_EQ(chunks[0].type, "IHDR");
  EXPECT_EQ(chunks[1].type, "tEXt");
  EXPECT_EQ(chunks[1].data, std::string("Software\0AUcast", 15));
  EXPECT_EQ(chunks[2].type, "tEXt");
  EXPECT_EQ(chunks[2].data, std::string("Face\0J\xFCrgen", 11));
  EXPECT_EQ(chunks[3].type, "iTXt") << "Latin-1 does not have that letter";
  EXPECT_EQ(chunks[3].data, std::string("Edited\0\0\0\0\0\xC5\x81ukasz", 18));
  EXPECT_EQ(chunks[4].type, "IDAT");
  EXPECT_EQ(chunks.back().type, "IEND");
  const auto back = read_png(file);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->rgba, image.rgba);
}

TEST(PngText, OnlyWhatIsPrintedIsLatin1) {
  const auto type_of = [](const char* text) {
    const std::string before(8 + 12 + 13 + 12, '\0');  // signature, IHDR, IEND
    const std::array<PngText, 1> texts{{{"Face", text}}};
    return with_texts(before, texts).substr(8 + 12 + 13 + 4, 4);
  };
  EXPECT_EQ(type_of(""), "tEXt");
  EXPECT_EQ(type_of("a\nb"), "tEXt");
  EXPECT_EQ(type_of("\xC2\xA0\xC3\xBF"), "tEXt");
  EXPECT_EQ(type_of("\xC2\x85"), "iTXt") << "a control character";
  EXPECT_EQ(type_of("\t"), "iTXt");
  EXPECT_EQ(type_of("\x7F"), "iTXt");
  EXPECT_EQ(type_of("\xC3"), "iTXt") << "no whole character";
}

}  // namespace
}  // namespace aucast::view
