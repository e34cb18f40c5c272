#include "common/sources/neutral.h"

#include <gtest/gtest.h>

namespace aucast::sources {
namespace {

Signals smiling(float value) {
  Signals signals = no_signals();
  signals[12] = value;
  return signals;
}

TEST(Neutral, IsTheMedianOfTheFirstSeconds) {
  NeutralMeter meter(0.5);
  // One row that is far off, as a blink at the start, moves no median.
  const float values[] = {0.3F, 0.1F, 1, 0.2F, 0.25F};
  double seconds = 3;
  for (const float value : values) {
    EXPECT_TRUE(meter.add(seconds, smiling(value)));
    seconds += 0.1;
  }
  EXPECT_FALSE(meter.done());
  EXPECT_FALSE(meter.add(3.5, smiling(1))) << "the first row after the seconds is none of them";
  EXPECT_TRUE(meter.done());
  const MeasuredNeutral measured = meter.measured();
  EXPECT_EQ(measured.rows, 5U);
  EXPECT_EQ(measured.seconds, 0.5);
  EXPECT_EQ(measured.signals[12], 0.25F);
  EXPECT_FALSE(is_signal(measured.signals[1])) << "never seen";
  EXPECT_NEAR(measured.movement[12], 0.1, 1e-6) << "without the lowest and the highest";
  EXPECT_FALSE(is_signal(measured.movement[1]));
}

TEST(Neutral, OfAnEvenNumberOfRowsIsBetweenTheMiddleTwo) {
  NeutralMeter meter(1);
  static_cast<void>(meter.add(0, smiling(0.5F)));
  static_cast<void>(meter.add(0.1, smiling(0.25F)));
  EXPECT_EQ(meter.measured().signals[12], 0.375F);
}

TEST(Neutral, ItsSecondsBeginWhenAFaceIsSeen) {
  NeutralMeter meter(1);
  for (int row = 0; row < 100; ++row) EXPECT_TRUE(meter.add(row, no_signals()));
  EXPECT_EQ(meter.measured().rows, 0U);
  EXPECT_FALSE(is_signal(meter.measured().signals[12]));
  EXPECT_TRUE(meter.add(100, smiling(0.5F)));
  EXPECT_TRUE(meter.add(100.5, smiling(0.5F)));
  EXPECT_FALSE(meter.add(101, smiling(0.5F)));
  EXPECT_EQ(meter.measured().rows, 2U);
}

TEST(Neutral, AFastSourceFillsNoMemory) {
  NeutralMeter meter(10);
  for (int row = 0; row < 100'000; ++row) {
    static_cast<void>(meter.add(row * 0.0001, smiling(row < 60'000 ? 0.25F : 0.5F)));
  }
  EXPECT_LE(meter.measured().rows, 2000U);
  EXPECT_GE(meter.measured().rows, 1900U);
  EXPECT_EQ(meter.measured().signals[12], 0.25F);
}

TEST(Neutral, WhatItDoesNotKnowIsNotTouched) {
  Signals signals = smiling(0.75F);
  signals[1] = 0.5F;
  take_off(signals, smiling(0.25F));
  EXPECT_EQ(signals[12], 0.5F);
  EXPECT_EQ(signals[1], 0.5F);
  Signals none = no_signals();
  take_off(none, smiling(0.25F));
  EXPECT_FALSE(is_signal(none[12])) << "no data stays no data";
}

}  // namespace
}  // namespace aucast::sources
