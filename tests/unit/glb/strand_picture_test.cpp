#include "client/glb/strand_picture.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace aucast::glb {
namespace {

TEST(StrandPicture, LeavesWholeHairWholeAndFraysItsEdge) {
  for (const bool grey : {false, true}) {
    const view::Image picture = strand_picture(grey);
    std::uint8_t thinnest = 255;
    std::uint8_t thickest = 0;
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4) {
      thinnest = std::min(thinnest, picture.rgba[i]);
      thickest = std::max(thickest, picture.rgba[i]);
    }
    EXPECT_GT(thinnest, 128) << "cut at half, or hair would have holes";
    EXPECT_GT(thickest - thinnest, 60);
  }
}

TEST(StrandPicture, GreyHairHasTheGreaterContrast) {
  const auto darkest = [](const view::Image& picture) {
    std::uint8_t least = 255;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
      least = std::min(least, picture.rgba[i]);
    }
    return least;
  };
  EXPECT_LT(darkest(strand_picture(true)), darkest(strand_picture(false)));
  EXPECT_EQ(strand_picture(false).rgba, strand_picture(false).rgba);
}

}  // namespace
}  // namespace aucast::glb
