#include "common/sources/observation.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/seeded.h"

namespace aucast::sources {
namespace {

TEST(Observation, AHeadAtItsFullTurnIsOneHundredPercent) {
  Observation row;
  row.add_head({35 * kRadPerDegree, -11 * kRadPerDegree, -22 * kRadPerDegree});
  ASSERT_EQ(row.aus.size(), 6U);
  const double expected[] = {1, 0, 0, 0.5, 0, 1};
  for (std::size_t index = 0; index < 6; ++index) {
    EXPECT_EQ(row.aus[index].number, 51 + index);
    EXPECT_NEAR(row.aus[index].value, expected[index], 1e-9) << 51 + index;
    EXPECT_FALSE(row.aus[index].native);
  }
}

TEST(Observation, GazeHasItsOwnDegrees) {
  Observation row;
  row.add_gaze({-14 * kRadPerDegree, 22 * kRadPerDegree, 0});
  ASSERT_EQ(row.aus.size(), 4U);
  EXPECT_NEAR(row.aus[1].value, 0.5, 1e-9) << "62, eyes right";
  EXPECT_NEAR(row.aus[2].value, 1, 1e-9) << "63, eyes up";
}

TEST(GazeInHead, AStraightHeadLeavesTheSightAlone) {
  const Rotation right_in_image = gaze_in_head({std::tan(0.2), 0, -1}, 0, 0, 0);
  EXPECT_NEAR(right_in_image.left_rad, 0.2, 1e-9) << "the image's right is the subject's left";
  const Rotation down = gaze_in_head({0, std::tan(0.1), -1}, 0, 0, 0);
  EXPECT_NEAR(down.up_rad, -0.1, 1e-9);
}

TEST(GazeInHead, EyesThatStayOnTheCameraTurnAgainstTheHead) {
  const CameraVector camera{0, 0, -1};
  // A positive yaw is the subject's right, so the eyes turn left in the head.
  EXPECT_NEAR(gaze_in_head(camera, 0, 0.3, 0).left_rad, 0.3, 1e-9);
  // A positive pitch is down, so the eyes turn up.
  EXPECT_NEAR(gaze_in_head(camera, 0.2, 0, 0).up_rad, 0.2, 1e-9);
  EXPECT_NEAR(gaze_in_head(camera, 0, 0, 0.4).left_rad, 0, 1e-9);
}

TEST(GazeInHead, EyesThatGoWithTheHeadAreStraight) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int round = 0; round < 100; ++round) {
    const double pitch = seeded.real(-0.8, 0.8);
    const double yaw = seeded.real(-0.8, 0.8);
    const double roll = seeded.real(-0.8, 0.8);
    // Rx Ry Rz of straight ahead, (0, 0, -1).
    const CameraVector ahead{-std::sin(yaw), std::sin(pitch) * std::cos(yaw),
                             -std::cos(pitch) * std::cos(yaw)};
    const Rotation turn = gaze_in_head(ahead, pitch, yaw, roll);
    EXPECT_NEAR(turn.left_rad, 0, 1e-9);
    EXPECT_NEAR(turn.up_rad, 0, 1e-9);
  }
}

}  // namespace
}  // namespace aucast::sources
