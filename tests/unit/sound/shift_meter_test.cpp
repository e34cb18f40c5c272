#include "client/sound/shift_meter.h"

#include <gtest/gtest.h>

namespace aucast::sound {
namespace {

TEST(ShiftMeter, HasNothingToSayOfNothing) {
  EXPECT_EQ(ShiftMeter().summary().count, 0U);
}

TEST(ShiftMeter, TellsMedianAndBothEnds) {
  ShiftMeter meter;
  for (int i = 1; i <= 100; ++i) meter.add(Milliseconds(i - 50));
  const ShiftSummary summary = meter.summary();
  EXPECT_EQ(summary.count, 100U);
  EXPECT_EQ(summary.median, Milliseconds(0));
  EXPECT_EQ(summary.low, Milliseconds(-45));
  EXPECT_EQ(summary.high, Milliseconds(45));
}

TEST(ShiftMeter, CountsWhatIsFarOffAsASecond) {
  ShiftMeter meter;
  meter.add(std::chrono::hours(1));
  EXPECT_EQ(meter.summary().median, std::chrono::seconds(1));
  meter.add(-std::chrono::hours(1));
  meter.add(-std::chrono::hours(1));
  EXPECT_EQ(meter.summary().median, -std::chrono::seconds(1));
}

}  // namespace
}  // namespace aucast::sound
