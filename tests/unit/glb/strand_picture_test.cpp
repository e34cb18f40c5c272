#include "client/glb/strand_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/face/small_face.h"

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

/// How light two rows or columns differ, in the mean over their pixels.
double step(const view::Image& picture, bool columns, int from, int to) {
  const auto light = [&](int line, int along) {
    const int x = columns ? line : along;
    const int y = columns ? along : line;
    return static_cast<int>(picture.rgba[static_cast<std::size_t>(4 * (y * picture.width + x))]);
  };
  const int length = columns ? picture.height : picture.width;
  double sum = 0;
  for (int i = 0; i < length; ++i) sum += std::abs(light(from, i) - light(to, i));
  return sum / length;
}

TEST(StrandPicture, BeginsAnewWithoutAnEdge) {
  const view::Image picture = strand_picture(false);
  double most = 0;
  for (int y = 1; y < picture.height; ++y) {
    most = std::max(most, step(picture, false, y - 1, y));
  }
  EXPECT_GT(most, 0);
  EXPECT_LE(step(picture, false, picture.height - 1, 0), most);
}

TEST(StrandPicture, StrandsAreColumnsThatChangeSlowly) {
  const view::Image picture = strand_picture(false);
  EXPECT_LT(2 * step(picture, false, 40, 41), step(picture, true, 40, 41));
}

TEST(StrandPicture, TimesItsGainHairKeepsItsOwnColour) {
  for (const bool grey : {false, true}) {
    const view::Image picture = strand_picture(grey);
    double sum = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
      EXPECT_EQ(picture.rgba[i], picture.rgba[i + 1]);
      EXPECT_EQ(picture.rgba[i], picture.rgba[i + 2]);
      const double share = picture.rgba[i] / 255.0;
      sum += share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    }
    const double mean = sum / (picture.width * picture.height);
    EXPECT_NEAR(mean * static_cast<double>(strand_picture_gain(grey)), 1, 0.1);
  }
}

TEST(StrandCoordinates, OneStrandHasOneColumnAndRunsDown) {
  face::Face face = face::test::small_face();
  std::vector<float> strands;
  for (std::size_t i = 0; i < face.mesh.positions.size(); ++i) {
    strands.push_back(0.01F * static_cast<float>(i % 41));  // a column of the skin
  }
  face.mesh.maps["strand"] = strands;
  Surface hair;
  for (std::uint32_t row = 0; row < 41; ++row) hair.vertices.push_back(41 * row + 20);
  const std::vector<glm::vec2> coordinates = strand_coordinates(face, hair);
  ASSERT_EQ(coordinates.size(), 41U);
  for (std::size_t i = 1; i < coordinates.size(); ++i) {
    EXPECT_EQ(coordinates[i].x, coordinates[0].x);
    EXPECT_LT(coordinates[i].y, coordinates[i - 1].y) << "rows go up, a picture's y goes down";
  }
}

}  // namespace
}  // namespace aucast::glb
