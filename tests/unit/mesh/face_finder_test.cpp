#include "common/mesh/face_finder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/unit/mesh/constant_net.h"

namespace aucast::mesh {
namespace {

using test::FaceBoxes;

constexpr float kPixels = FaceBoxes::kPixels;

Result<FaceFinder> finder_of(const FaceBoxes& seer) {
  const std::string file = seer.file();
  return FaceFinder::make(test::bytes_of(file), "seer.tflite");
}

/// In a picture twice as wide as high.
std::vector<Square> faces(const FaceBoxes& seer, std::size_t most = 9) {
  const std::vector<std::uint8_t> black(3 * 256 * 128, 0);
  auto found = finder_of(seer);
  EXPECT_TRUE(found.has_value()) << found.error().message;
  return found ? found->find({256, 128, black}, most) : std::vector<Square>{};
}

TEST(FaceFinder, IsWhereItWasLookedFromAndMoves) {
  for (const std::size_t second : {0U, 1U}) {
    FaceBoxes seer;
    seer.sees(FaceBoxes::fine(4, 7) + second, 3, 16, 2, -1);
    const auto found = faces(seer);
    ASSERT_EQ(found.size(), 1U);
    // The wider side of the picture fills the net's 128 pixels, so one of them is two of ours.
    EXPECT_NEAR(found[0].x, 2 * ((4.5 / 16) * kPixels + 2), 1e-4);
    EXPECT_NEAR(found[0].y, 2 * ((7.5 / 16) * kPixels - 1) - 64, 1e-4) << "bars above and below";
    EXPECT_NEAR(found[0].side, 2 * 16 * 1.5, 1e-4);
    EXPECT_NEAR(found[0].turn_rad, 0, 1e-6);
  }
  for (const std::size_t sixth : {0U, 5U}) {
    FaceBoxes seer;
    seer.sees(FaceBoxes::coarse(2, 3) + sixth, 3, 40);
    const auto found = faces(seer);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].x, 2 * (2.5 / 8) * kPixels, 1e-4);
    EXPECT_NEAR(found[0].y, 2 * (3.5 / 8) * kPixels - 64, 1e-4);
    EXPECT_NEAR(found[0].side, 2 * 40 * 1.5, 1e-4);
  }
}

TEST(FaceFinder, IsLevelWithTheEyes) {
  FaceBoxes seer;
  seer.sees(FaceBoxes::fine(8, 8), 3, 16, 0, 0, 10);
  const auto found = faces(seer);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].turn_rad, std::atan2(10, 10), 1e-6);
}

TEST(FaceFinder, TheClearestIsFirstAndEachFaceIsFoundOnce) {
  FaceBoxes seer;
  seer.sees(FaceBoxes::fine(3, 8), 1, 16);
  seer.sees(FaceBoxes::fine(3, 8) + 1, 2, 16, 1, 0);  // the same, a little clearer
  seer.sees(FaceBoxes::fine(12, 8), 4, 16);
  seer.sees(FaceBoxes::coarse(6, 4), 3, 16);  // the second one from farther away
  const auto found = faces(seer);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].x, 2 * (12.5 / 16) * kPixels, 1e-4);
  EXPECT_NEAR(found[1].x, 2 * ((3.5 / 16) * kPixels + 1), 1e-4);
  const auto one = faces(seer, 1);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].x, found[0].x);
}

TEST(FaceFinder, WhatIsNotSureOrCannotBeSeenIsNone) {
  FaceBoxes seer;
  EXPECT_TRUE(faces(seer).empty());
  seer.sees(FaceBoxes::fine(8, 8), -0.01F, 16);
  EXPECT_TRUE(faces(seer).empty());
  seer.sees(FaceBoxes::fine(8, 8), 0, 16);
  EXPECT_EQ(faces(seer).size(), 1U) << "as sure as it must be";
  for (const float size : {0.0F, -16.0F, NAN, INFINITY}) {
    seer.sees(FaceBoxes::fine(8, 8), 9, size);
    EXPECT_TRUE(faces(seer).empty()) << size;
  }
  seer.sees(FaceBoxes::fine(8, 8), NAN, 16);
  EXPECT_TRUE(faces(seer).empty());
}

TEST(FaceFinder, AnotherNetIsRefused) {
  FaceBoxes small;
  small.side = 64;
  FaceBoxes few;
  few.scores.pop_back();
  few.boxes.resize(few.scores.size() * FaceBoxes::kEach);
  for (const FaceBoxes& other : {small, few}) {
    const auto finder = finder_of(other);
    ASSERT_FALSE(finder.has_value());
    EXPECT_EQ(finder.error().kind, ErrorKind::BadData);
    EXPECT_EQ(finder.error().message,
              "seer.tflite: not a model that can be used: it is not MediaPipe's face detector");
  }
}

}  // namespace
}  // namespace aucast::mesh
