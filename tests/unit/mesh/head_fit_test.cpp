#include "common/mesh/head_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/mesh/measures.h"
#include "common/mesh/picture.h"

namespace aucast::mesh {
namespace {

constexpr double kFitTolerance = 1e-6;

/// The typical face turned in camera space (x right, y down, z away): first tilted about z, then
/// nodded about x, then turned about y, and 100 times as large.
Landmarks typical_face(double turn_left, double up, double tilt_left) {
  Landmarks landmarks;
  for (std::size_t i = 0; i < kStillLandmarks.size(); ++i) {
    Point p = kTypicalStillPoints[i];
    // The subject's left is the picture's right: tilting there is clockwise.
    p = {std::cos(tilt_left) * p.x - std::sin(tilt_left) * p.y,
         std::sin(tilt_left) * p.x + std::cos(tilt_left) * p.y, p.z};
    // Up: the nose, which is nearest (z < 0), goes up (y < 0).
    p = {p.x, std::cos(up) * p.y + std::sin(up) * p.z, -std::sin(up) * p.y + std::cos(up) * p.z};
    // Left: the nose goes to the picture's right.
    p = {std::cos(turn_left) * p.x - std::sin(turn_left) * p.z, p.y,
         std::sin(turn_left) * p.x + std::cos(turn_left) * p.z};
    landmarks.points[kStillLandmarks[i]] = {100 * p.x + 320, 100 * p.y + 240, 100 * p.z};
  }
  return landmarks;
}

TEST(HeadFit, FindsEachTurnByTheSubjectsOwnLeft) {
  const HeadTurn left = fit_head(typical_face(0.4, 0, 0), kTypicalStillPoints).turn;
  EXPECT_NEAR(left.left_rad, 0.4, kFitTolerance);
  EXPECT_NEAR(left.up_rad, 0, kFitTolerance);
  EXPECT_NEAR(left.tilt_left_rad, 0, kFitTolerance);
  const HeadTurn up = fit_head(typical_face(0, 0.3, 0), kTypicalStillPoints).turn;
  EXPECT_NEAR(up.up_rad, 0.3, kFitTolerance);
  EXPECT_NEAR(up.left_rad, 0, kFitTolerance);
  const HeadTurn tilted = fit_head(typical_face(0, 0, 0.2), kTypicalStillPoints).turn;
  EXPECT_NEAR(tilted.tilt_left_rad, 0.2, kFitTolerance);
  EXPECT_NEAR(tilted.left_rad, 0, kFitTolerance);
}

TEST(HeadFit, TakesTurnPlaceAndSizeBack) {
  const FittedHead head = fit_head(typical_face(-0.5, 0.2, 0.3), kTypicalStillPoints);
  EXPECT_NEAR(head.scale, 100, 1e-4);
  for (std::size_t i = 0; i < kStillLandmarks.size(); ++i) {
    const Point& p = head.points[kStillLandmarks[i]];
    EXPECT_NEAR(p.x, kTypicalStillPoints[i].x, kFitTolerance);
    EXPECT_NEAR(p.y, kTypicalStillPoints[i].y, kFitTolerance);
    EXPECT_NEAR(p.z, kTypicalStillPoints[i].z, kFitTolerance);
  }
}

TEST(HeadFit, BearsPointsThatAreAllTheSame) {
  const FittedHead head = fit_head(Landmarks{}, kTypicalStillPoints);
  EXPECT_TRUE(std::isfinite(head.turn.left_rad));
  EXPECT_TRUE(std::isfinite(head.points[0].x));
}

TEST(Measures, TellTheSidesApart) {
  FittedHead head;
  for (std::size_t i = 0; i < kStillLandmarks.size(); ++i) {
    head.points[kStillLandmarks[i]] = kTypicalStillPoints[i];
  }
  head.points[291] = {0.3, 0.7, 0};  // the left corner of the mouth, out and up
  head.points[61] = {-0.25, 0.8, 0};
  for (const std::size_t lid : {374U, 380U, 373U}) head.points[lid].y = 0.1;
  const Measures measures = measure(head);
  const auto left = [&](SideMeasure what) { return measures.left[static_cast<std::size_t>(what)]; };
  const auto right = [&](SideMeasure what) {
    return measures.right[static_cast<std::size_t>(what)];
  };
  EXPECT_NEAR(left(SideMeasure::CornerUp), -0.7, kFitTolerance);
  EXPECT_NEAR(left(SideMeasure::CornerOut), 0.3, kFitTolerance);
  EXPECT_NEAR(right(SideMeasure::CornerUp), -0.8, kFitTolerance);
  EXPECT_NEAR(right(SideMeasure::CornerOut), 0.25, kFitTolerance);
  EXPECT_GT(left(SideMeasure::Aperture), 0.3);
  EXPECT_NEAR(right(SideMeasure::Aperture), 0, kFitTolerance);
  EXPECT_NEAR(measures.middle[static_cast<std::size_t>(MiddleMeasure::MouthWidth)], 0.55,
              kFitTolerance);
}

TEST(Measures, HaveHeightsOfWhatNoExpressionMoves) {
  FittedHead head;
  head.points[162].y = -0.2;  // right and left temple
  head.points[389].y = -0.4;
  head.points[4].y = 0.35;
  const Measures measures = measure(head);
  const auto of = [&](MiddleMeasure what) {
    return measures.middle[static_cast<std::size_t>(what)];
  };
  EXPECT_NEAR(of(MiddleMeasure::StillTempleHighUp), 0.3, kFitTolerance);
  EXPECT_NEAR(of(MiddleMeasure::StillTipUp), -0.35, kFitTolerance);
  EXPECT_EQ(middle_measure_names()[static_cast<std::size_t>(MiddleMeasure::StillTempleHighUp)],
            "still-temple-high-up");
  EXPECT_EQ(middle_measure_names().back(), "still-jaw-hinge-up");
}

TEST(Picture, ASquareIsSampledTurnedAndBlackOutside) {
  // 4x2 pixels: red is 10 times the column, green 100 times the row.
  std::vector<std::uint8_t> rgb;
  for (std::uint8_t row = 0; row < 2; ++row) {
    for (std::uint8_t column = 0; column < 4; ++column) {
      rgb.insert(rgb.end(), {static_cast<std::uint8_t>(10 * column),
                             static_cast<std::uint8_t>(100 * row), 255});
    }
  }
  const Picture picture{4, 2, rgb};
  std::vector<float> out(2 * 2 * 3);
  sample_square(picture, {2, 1, 2, 0}, 2, 0, 255, out);
  EXPECT_EQ(out, (std::vector<float>{10, 0, 255, 20, 0, 255, 10, 100, 255, 20, 100, 255}));
  // A quarter clockwise: the square's right is the picture's bottom.
  sample_square(picture, {2, 1, 2, std::acos(0.0)}, 2, 0, 255, out);
  EXPECT_NEAR(out[0], 20, 1e-3);
  EXPECT_NEAR(out[1], 0, 1e-3);
  EXPECT_NEAR(out[3], 20, 1e-3);
  EXPECT_NEAR(out[4], 100, 1e-3);
  sample_square(picture, {-8, -8, 2, 0}, 2, -1, 1, out);
  EXPECT_EQ(out, std::vector<float>(12, -1));
}

}  // namespace
}  // namespace aucast::mesh
