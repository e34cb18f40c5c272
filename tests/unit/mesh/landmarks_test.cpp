#include "common/mesh/landmarks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "common/mesh/face_tracker.h"
#include "tests/unit/mesh/constant_net.h"

namespace aucast::mesh {
namespace {

using test::FaceBoxes;
using test::FacePoints;

constexpr std::size_t kWidth = 256;
constexpr std::size_t kHeight = 128;

/// A picture that shows nothing; the nets here see the same anyway.
Picture black() {
  static const std::vector<std::uint8_t> bytes(3 * kWidth * kHeight, 0);
  return {kWidth, kHeight, bytes};
}

Result<LandmarkFinder> finder_of(const FacePoints& seer) {
  const std::string file = seer.file();
  return LandmarkFinder::make(test::bytes_of(file), "mesh.tflite");
}

Landmarks found_in(const FacePoints& seer, const Square& square) {
  auto finder = finder_of(seer);
  EXPECT_TRUE(finder.has_value()) << finder.error().message;
  return finder ? finder->find(black(), square) : Landmarks{};
}

void expect_at(const Point& point, double x, double y, double z) {
  EXPECT_NEAR(point.x, x, 1e-4);
  EXPECT_NEAR(point.y, y, 1e-4);
  EXPECT_NEAR(point.z, z, 1e-4);
}

TEST(Landmarks, AreWhereTheSquareShowsThem) {
  FacePoints seer;
  seer.put(10, 96, 96, 0);
  seer.put(152, 106, 116, -3);
  // The net's 192 pixels are 384 of the picture.
  const Landmarks level = found_in(seer, {100, 50, 384, 0});
  expect_at(level.points[10], 100, 50, 0);
  expect_at(level.points[152], 120, 90, -6);
  const Landmarks turned = found_in(seer, {100, 50, 384, std::numbers::pi / 2});
  expect_at(turned.points[10], 100, 50, 0);
  expect_at(turned.points[152], 60, 70, -6);
}

TEST(Landmarks, OfLipsAndEyesAreThoseSeenFromNearby) {
  FacePoints seer;
  // The first and the last of each part, as MediaPipe lists them.
  const auto check = [&](std::vector<float>& part, std::size_t first, std::size_t last) {
    seer.put(first, 1, 2, 3);
    seer.put(last, 4, 5, 6);
    part[0] = 50;
    part[1] = 60;
    part[part.size() - 2] = 70;
    part[part.size() - 1] = 80;
    const Landmarks landmarks = found_in(seer, {96, 96, 192, 0});
    expect_at(landmarks.points[first], 50, 60, 3);
    expect_at(landmarks.points[last], 70, 80, 6);
  };
  check(seer.lips, 61, 407);
  check(seer.right_eye, 33, 193);
  check(seer.left_eye, 263, 417);
}

TEST(Landmarks, AnIrisLiesAsDeepAsItsLids) {
  FacePoints seer;
  const std::size_t lids[] = {33,  7,   163, 144, 145, 153, 154, 155,
                              133, 246, 161, 160, 159, 158, 157, 173};
  for (std::size_t index = 0; index < 16; ++index) {
    seer.put(lids[index], 0, 0, static_cast<float>(index + 1));
  }
  for (std::size_t index = 0; index < 10; ++index) {
    seer.right_iris[index] = static_cast<float>(index);
    seer.left_iris[index] = static_cast<float>(100 + index);
  }
  const Landmarks landmarks = found_in(seer, {96, 96, 192, 0});
  for (std::size_t index = 0; index < kIrisPoints; ++index) {
    const auto x = static_cast<double>(2 * index);
    expect_at(landmarks.points[kRightIris + index], x, x + 1, 8.5);
    expect_at(landmarks.points[kLeftIris + index], 100 + x, 101 + x, 96);
  }
}

TEST(Landmarks, AnotherNetIsRefused) {
  FacePoints small;
  small.side = 128;
  FacePoints few;
  few.left_eye.pop_back();
  FacePoints flags;
  flags.presence.push_back(0);
  for (const FacePoints& other : {small, few, flags}) {
    const auto finder = finder_of(other);
    ASSERT_FALSE(finder.has_value());
    EXPECT_EQ(finder.error().message,
              "mesh.tflite: not a model that can be used: it is not MediaPipe's face mesh with "
              "attention");
  }
}

TEST(Landmarks, TheNextSquareIsAroundThemAndLevelWithTheEyes) {
  Landmarks landmarks;
  landmarks.points.fill({100, 60, 0});
  landmarks.points[10].y = 40;
  landmarks.points[152].y = 80;
  landmarks.points[33] = {90, 55, 0};
  landmarks.points[263] = {110, 65, 0};
  landmarks.points[kLeftIris] = {900, 900, 0};  // what is no point of the face does not count
  const Square square = square_around(landmarks);
  EXPECT_EQ(square.x, 100);
  EXPECT_EQ(square.y, 60);
  EXPECT_EQ(square.side, 1.5 * 40) << "the longer way";
  EXPECT_EQ(square.turn_rad, std::atan2(10, 20));
}

/// Two faces beside each other, whose landmarks fill two thirds of their squares.
class Tracker : public ::testing::Test {
 protected:
  Tracker() {
    boxes_.sees(FaceBoxes::fine(3, 8), 2, 16);
    boxes_.sees(FaceBoxes::fine(12, 8), 4, 16);
    points_.put(10, 96, 32, 0);
    points_.put(152, 96, 160, 0);
    points_.right_eye[0] = 64;  // the outer corner of the eye
    points_.left_eye[0] = 128;
  }
  [[nodiscard]] FaceTracker tracker() const {
    const std::string boxes = boxes_.file();
    const std::string points = points_.file();
    auto made = FaceTracker::make({test::bytes_of(boxes), "detector"},
                                  {test::bytes_of(points), "landmarks"});
    EXPECT_TRUE(made.has_value()) << made.error().message;
    return std::move(*made);
  }

  static constexpr double kLeftX = 2 * (3.5 / 16) * FaceBoxes::kPixels;
  static constexpr double kRightX = 2 * (12.5 / 16) * FaceBoxes::kPixels;
  FaceBoxes boxes_;
  FacePoints points_;
};

TEST_F(Tracker, FollowsTheClearestFace) {
  auto faces = tracker();
  for (int picture = 0; picture < 3; ++picture) {
    const auto landmarks = faces.follow(black());
    ASSERT_TRUE(landmarks.has_value());
    EXPECT_NEAR(square_around(*landmarks).x, kRightX, 1e-3);
    EXPECT_NEAR(landmarks->presence, 1, 1e-6);
  }
}

TEST_F(Tracker, FollowsAllFacesInTheOrderOfTheirNumbers) {
  auto faces = tracker();
  for (int picture = 0; picture < 2 * FaceTracker::kSearchEvery; ++picture) {
    const auto seen = faces.follow_all(black());
    ASSERT_EQ(seen.size(), 2U) << picture;
    EXPECT_EQ(seen[0].number, 0U);
    EXPECT_NEAR(square_around(seen[0].landmarks).x, kRightX, 1e-3) << "the clearest came first";
    EXPECT_EQ(seen[1].number, 1U);
    EXPECT_NEAR(square_around(seen[1].landmarks).x, kLeftX, 1e-3);
  }
}

TEST_F(Tracker, WhatIsHardlyAFaceIsNone) {
  points_.presence = {-0.01F};
  auto faces = tracker();
  EXPECT_FALSE(faces.follow(black()).has_value());
  EXPECT_TRUE(tracker().follow_all(black()).empty());
  points_.presence = {0.0F};
  EXPECT_TRUE(tracker().follow(black()).has_value()) << "as sure as it must be";
}

TEST_F(Tracker, APictureThatIsNotWholeShowsNobody) {
  Picture half = black();
  half.rgb = half.rgb.first(half.rgb.size() - 1);
  auto faces = tracker();
  EXPECT_FALSE(faces.follow(half).has_value());
  EXPECT_FALSE(faces.follow({}).has_value());
  EXPECT_TRUE(faces.follow_all(half).empty());
}

TEST_F(Tracker, SaysWhichOfTheModelsIsWrong) {
  const std::string boxes = boxes_.file();
  const std::string points = points_.file();
  const auto wrong = [](const std::string& detector, const std::string& landmarks) {
    const auto made = FaceTracker::make({test::bytes_of(detector), "detector"},
                                        {test::bytes_of(landmarks), "landmarks"});
    return made ? std::string() : made.error().message.substr(0, made.error().message.find(':'));
  };
  EXPECT_EQ(wrong(boxes, points), "");
  EXPECT_EQ(wrong(points, points), "detector");
  EXPECT_EQ(wrong(boxes, boxes), "landmarks");
}

}  // namespace
}  // namespace aucast::mesh
