#include "common/camera/y4m.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

namespace aucast::camera {
namespace {

Y4mReader::Read reads(std::string text, std::size_t at_once = 1000) {
  return [text = std::move(text), at_once](std::span<std::uint8_t> bytes) mutable {
    const std::size_t count = std::min({bytes.size(), text.size(), at_once});
    std::memcpy(bytes.data(), text.data(), count);
    text.erase(0, count);
    return count;
  };
}

const std::string kHead = "YUV4MPEG2 W2 H1 F30000:1001 Ip A1:1 C444 XYSCSS=444\n";
/// Black and white, then red twice.
const std::string kPictures = std::string("FRAME\n\x10\xeb\x80\x80\x80\x80", 12) +
                              std::string("FRAME\n\x51\x51\x5a\x5a\xf0\xf0", 12);

TEST(Y4m, PicturesComeAsRgb) {
  for (const std::size_t at_once : {1000U, 1U}) {
    auto reader = Y4mReader::open(reads(kHead + kPictures, at_once));
    ASSERT_TRUE(reader.has_value());
    ASSERT_TRUE(reader->has_value());
    Y4mReader& pictures = **reader;
    EXPECT_EQ(pictures.width(), 2U);
    EXPECT_EQ(pictures.height(), 1U);
    EXPECT_NEAR(pictures.fps(), 29.97, 0.001);
    std::vector<std::uint8_t> rgb;
    ASSERT_TRUE(pictures.next(rgb));
    EXPECT_EQ(rgb, (std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255}));
    ASSERT_TRUE(pictures.next(rgb));
    EXPECT_NEAR(rgb[0], 255, 2);
    EXPECT_NEAR(rgb[1], 0, 2);
    EXPECT_NEAR(rgb[2], 0, 2);
    EXPECT_FALSE(pictures.next(rgb));
  }
}

TEST(Y4m, APictureThatIsCutOffIsNone) {
  auto reader = Y4mReader::open(reads(kHead + kPictures.substr(0, 20)));
  ASSERT_TRUE(reader.has_value() && reader->has_value());
  std::vector<std::uint8_t> rgb;
  EXPECT_TRUE((*reader)->next(rgb));
  EXPECT_FALSE((*reader)->torn());
  EXPECT_FALSE((*reader)->next(rgb));
  EXPECT_TRUE((*reader)->torn());
}

TEST(Y4m, OtherThingsAreRefused) {
  for (const std::string head :
       {"hello\n", "YUV4MPEG2 W0 H1 F25:1 C444\n", "YUV4MPEG2 W2 H99999 F25:1 C444\n",
        "YUV4MPEG2 W2 H1 F0:1 C444\n", "YUV4MPEG2 W2 H1 F25:1 C420\n", "YUV4MPEG2 W2 H1 C444\n"}) {
    const auto reader = Y4mReader::open(reads(head));
    ASSERT_FALSE(reader.has_value()) << head;
    EXPECT_EQ(reader.error().kind, ErrorKind::BadData);
  }
  const auto nothing = Y4mReader::open(reads(""));
  ASSERT_TRUE(nothing.has_value());
  EXPECT_FALSE(nothing->has_value());
}

}  // namespace
}  // namespace aucast::camera
