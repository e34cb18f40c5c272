#include "client/playback/blinking.h"

#include <gtest/gtest.h>

namespace aucast::playback {
namespace {

TEST(BlinkClosure, BlinksOnceInEveryIntervalAndStaysInRange) {
  for (int interval = 0; interval < 50; ++interval) {
    int closings = 0;
    bool open = true;
    for (int step = 0; step < 4000; ++step) {
      const float closure = blink_closure({.seed = 1}, interval * 4.0 + step * 0.001);
      ASSERT_GE(closure, 0.0F);
      ASSERT_LE(closure, 1.0F);
      if (open && closure == 1.0F) ++closings;
      open = closure < 1.0F;
    }
    EXPECT_EQ(closings, 1) << interval;
  }
}

TEST(BlinkClosure, IsContinuous) {
  float before = blink_closure({.seed = 3}, 0);
  for (int step = 1; step < 20000; ++step) {
    const float closure = blink_closure({.seed = 3}, step * 0.001);
    EXPECT_NEAR(closure, before, 0.011F);
    before = closure;
  }
}

TEST(BlinkClosure, TakesItsTimesFromTheOptions) {
  const BlinkOptions options{7, 1000, 25, Interpolation::Cosine};
  for (int interval = 0; interval < 20; ++interval) {
    int moving = 0;
    for (int step = 0; step < 1000; ++step) {
      if (blink_closure(options, interval + step * 0.001) > 0) ++moving;
    }
    EXPECT_NEAR(moving, 75, 2) << interval;
  }
}

TEST(BlinkClosure, NeverOutgrowsItsInterval) {
  const BlinkOptions options{7, 500, 500, Interpolation::Linear};
  float before = 0;
  for (int step = 0; step < 20000; ++step) {
    const float closure = blink_closure(options, step * 0.001);
    EXPECT_NEAR(closure, before, 0.014F);
    before = closure;
  }
}

TEST(BlinkClosure, DependsOnTheSeedAndNothingElse) {
  int different = 0;
  for (int step = 0; step < 4000; ++step) {
    const double t = step * 0.001;
    EXPECT_EQ(blink_closure({.seed = 5}, t), blink_closure({.seed = 5}, t));
    if (blink_closure({.seed = 5}, t) != blink_closure({.seed = 6}, t)) ++different;
  }
  EXPECT_GT(different, 0);
}

}  // namespace
}  // namespace aucast::playback
