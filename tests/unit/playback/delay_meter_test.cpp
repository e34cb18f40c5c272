#include "client/playback/delay_meter.h"

#include <gtest/gtest.h>

namespace aucast::playback {
namespace {

using namespace std::chrono_literals;

TEST(DelayMeter, HasNothingToSayAtFirst) {
  const DelayMeter meter;
  EXPECT_EQ(meter.all().keyframes, 0U);
  EXPECT_EQ(meter.lately().keyframes, 0U);
  EXPECT_EQ(meter.all().longest, Duration::zero());
}

TEST(DelayMeter, KnowsTheUsualAndTheLongest) {
  DelayMeter meter;
  for (const Duration delay : {Duration(45ms), Duration(41'400us), Duration(300ms)}) {
    meter.add(delay);
  }
  for (const DelaySummary& summary : {meter.all(), meter.lately()}) {
    EXPECT_EQ(summary.keyframes, 3U);
    EXPECT_EQ(summary.median, 45ms);
    EXPECT_EQ(summary.longest, 300ms);
  }
  meter.add(41'400us);
  EXPECT_EQ(meter.all().median, 41ms) << "of four the second";
  EXPECT_EQ(meter.lately().median, 41ms);
}

TEST(DelayMeter, ForgetsForThePanelButNotInAll) {
  DelayMeter meter;
  for (int i = 0; i < 1000; ++i) meter.add(700ms);
  for (int i = 0; i < 256; ++i) meter.add(40ms);
  EXPECT_EQ(meter.lately().median, 40ms);
  EXPECT_EQ(meter.lately().longest, 40ms);
  EXPECT_EQ(meter.all().median, 700ms);
  EXPECT_EQ(meter.all().keyframes, 1256U);
}

TEST(DelayMeter, TakesAnyDelay) {
  DelayMeter meter;
  meter.add(1h);
  EXPECT_EQ(meter.all().median, 10s);
  EXPECT_EQ(meter.all().longest, 1h);
  EXPECT_EQ(meter.lately().median, 1h);
  for (int i = 0; i < 3; ++i) meter.add(-5ms);
  EXPECT_EQ(meter.all().median, 0ms);
}

}  // namespace
}  // namespace aucast::playback
