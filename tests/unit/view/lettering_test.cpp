#include "client/view/lettering.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace aucast::view {
namespace {

constexpr std::uint32_t kWhite = 0xffffff;
constexpr std::uint32_t kBlack = 0x000000;

std::string drawn(const std::string& text) {
  Image image = make_image(40, 32, kWhite);
  draw_text(image, 8, 6, text, 14, kBlack);
  return {image.rgba.begin(), image.rgba.end()};
}

TEST(DrawText, GivesEveryPrintableCharacterAShapeOfItsOwn) {
  std::set<std::string> shapes;
  for (char character = ' '; character <= '~'; ++character) {
    EXPECT_TRUE(shapes.insert(drawn(std::string(1, character))).second) << character;
  }
  EXPECT_EQ(shapes.size(), 95U);
}

TEST(DrawText, DrawsNothingForABlank) {
  EXPECT_EQ(drawn("  "), drawn(""));
}

TEST(DrawText, ShowsOtherBytesAsAQuestionMark) {
  EXPECT_EQ(drawn("\x07"), drawn("?"));
  EXPECT_EQ(drawn("\xc3\xa4"), drawn("??"));
  EXPECT_EQ(drawn("\x7f"), drawn("?"));
}

TEST(DrawText, IsCutAtTheBorders) {
  for (const auto& [x, y] : std::vector<std::pair<int, int>>{
           {-300, 0}, {300, 0}, {0, -300}, {0, 300}, {-5, -5}, {38, 30}}) {
    Image image = make_image(40, 32, kWhite);
    draw_text(image, x, y, "Long enough to leave", 14, kBlack);
    EXPECT_EQ(image.rgba.size(), 40U * 32U * 4U);
  }
}

TEST(DrawText, StaysOpaqueAndInTheInksRange) {
  Image image = make_image(60, 32, 0x808080);
  draw_text(image, 4, 4, "Agq", 14, 0x204060);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    EXPECT_LE(image.rgba[i], 0x80);
    EXPECT_GE(image.rgba[i], 0x20);
    EXPECT_EQ(image.rgba[i + 3], 255);
  }
}

TEST(TextWidth, GrowsWithTheTextAndTheSize) {
  EXPECT_EQ(text_width("", 12), 0);
  EXPECT_LT(text_width("i", 12), text_width("m", 12));
  EXPECT_LT(text_width("ab", 12), text_width("abc", 12));
  EXPECT_NEAR(text_width("Surprise", 24), 2 * text_width("Surprise", 12), 1);
}

TEST(TextWidth, HoldsWhatIsDrawn) {
  for (const int cap_height : {9, 14, 24}) {
    Image image = make_image(600, 60, kWhite);
    const std::string text = "AU 12: 80 % (Lip Corner Puller)";
    draw_text(image, 0, 10, text, cap_height, kBlack);
    const int width = text_width(text, cap_height);
    for (int y = 0; y < image.height; ++y) {
      for (int x = width + 1; x < image.width; ++x) {
        ASSERT_EQ(image.rgba[4 * (static_cast<std::size_t>(y) * 600 + static_cast<std::size_t>(x))],
                  255)
            << x << ' ' << y;
      }
    }
  }
}

}  // namespace
}  // namespace aucast::view
