#include "client/playback/idle_life.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace aucast::playback {
namespace {

constexpr double kStep = 0.001;

double away(const IdleMotion& motion) {
  return std::hypot(motion.gaze_left_deg, motion.gaze_up_deg);
}

TEST(IdleLife, EyesRestOnTheViewerOrOneToThreeDegreesAway) {
  for (const std::uint64_t seed : {1U, 2U, 77U}) {
    int resting = 0;
    int moving = 0;
    double largest = 0;
    for (int step = 1; step < 300'000; ++step) {
      const IdleMotion before = idle_motion(seed, (step - 1) * kStep);
      const IdleMotion now = idle_motion(seed, step * kStep);
      const bool moves =
          before.gaze_left_deg != now.gaze_left_deg || before.gaze_up_deg != now.gaze_up_deg;
      (moves ? moving : resting)++;
      ASSERT_LE(away(now), 3 + 1e-9);
      ASSERT_LE(std::abs(now.gaze_up_deg), 3 * std::sin(0.6) + 1e-9);
      if (!moves && away(now) > 0) {
        ASSERT_GE(away(now), 1 - 1e-9) << "seed " << seed << " at " << step * kStep;
      }
      largest = std::max(largest, away(now));
    }
    EXPECT_GT(largest, 2.5);
    // 200 saccades of 27 to 33 ms in 300 s.
    EXPECT_NEAR(moving, 200 * 30, 600) << "seed " << seed;
    EXPECT_GT(resting, moving);
  }
}

TEST(IdleLife, LooksToBothSides) {
  double left = 0;
  double right = 0;
  for (int step = 0; step < 2000; ++step) {
    const double gaze = idle_motion(5, step * 0.1).gaze_left_deg;
    left = std::max(left, gaze);
    right = std::min(right, gaze);
  }
  EXPECT_GT(left, 2);
  EXPECT_LT(right, -2);
}

TEST(IdleLife, BreathesTwelveToSixteenTimesAMinute) {
  for (const std::uint64_t seed : {1U, 9U, 1234U}) {
    std::vector<double> ends;
    double before = idle_motion(seed, 0).breath;
    double now = idle_motion(seed, kStep).breath;
    for (int step = 1; step + 1 < 600'000; ++step) {
      const double after = idle_motion(seed, (step + 1) * kStep).breath;
      ASSERT_GE(now, 0);
      ASSERT_LE(now, 1);
      ASSERT_NEAR(now, before, 0.002) << "a jump at " << step * kStep;
      if (before > now && now <= after) ends.push_back(step * kStep);
      before = std::exchange(now, after);
    }
    ASSERT_GE(ends.size(), 120U);
    ASSERT_LE(ends.size(), 160U);
    for (std::size_t i = 1; i < ends.size(); ++i) {
      EXPECT_GE(ends[i] - ends[i - 1], 60 / 16.6) << "seed " << seed;
      EXPECT_LE(ends[i] - ends[i - 1], 60 / 12.0) << "seed " << seed;
    }
  }
}

TEST(IdleLife, DependsOnSeedAndTimeAlone) {
  const IdleMotion one = idle_motion(3, 12.345);
  static_cast<void>(idle_motion(3, 500));
  const IdleMotion again = idle_motion(3, 12.345);
  EXPECT_EQ(one.gaze_left_deg, again.gaze_left_deg);
  EXPECT_EQ(one.gaze_up_deg, again.gaze_up_deg);
  EXPECT_EQ(one.breath, again.breath);
  EXPECT_NE(idle_motion(3, 12.345).breath, idle_motion(4, 12.345).breath);
}

TEST(IdleLife, BeginsWithTheEyesOnTheViewerBreathedOut) {
  const IdleMotion begin = idle_motion(1, 0);
  EXPECT_EQ(away(begin), 0);
  EXPECT_EQ(begin.breath, 0);
  EXPECT_EQ(idle_motion(1, -5).breath, 0);
}

}  // namespace
}  // namespace aucast::playback
