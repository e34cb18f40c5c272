#include "client/playback/jitter_meter.h"

#include <gtest/gtest.h>

#include "tests/support/manual_clock.h"
#include "tests/support/seeded.h"

namespace aucast::playback {
namespace {

using namespace std::chrono_literals;
using aucast::test::ManualClock;

TEST(JitterMeter, IsZeroForWhatComesInTime) {
  ManualClock clock;
  JitterMeter meter;
  EXPECT_FALSE(meter.spread());
  for (int i = 0; i < 100; ++i) {
    meter.arrived(clock.now(), 40ms);
    EXPECT_EQ(meter.spread(), Duration(0ms));
    clock.advance(40ms);
  }
}

TEST(JitterMeter, IsTheDelayThatWouldHaveBeenNeeded) {
  ManualClock clock;
  JitterMeter meter;
  for (int i = 0; i < 10; ++i, clock.advance(40ms)) meter.arrived(clock.now(), 40ms);
  clock.advance(900ms);  // one is lost and comes again, with those behind it
  for (int i = 0; i < 23; ++i) meter.arrived(clock.now(), 40ms);
  EXPECT_EQ(meter.spread(), Duration(900ms));
  // Half a minute later it is forgotten.
  Instant next = clock.now() + 20ms;
  for (int i = 0; i < 800; ++i, next += 40ms) meter.arrived(next, 40ms);
  EXPECT_LT(*meter.spread(), 100ms);
}

TEST(JitterMeter, KeepsWhatItKnowsOverAReconnect) {
  ManualClock clock;
  JitterMeter meter;
  meter.arrived(clock.now(), 40ms);
  clock.advance(540ms);
  meter.arrived(clock.now(), 40ms);
  meter.begin_again();
  EXPECT_EQ(meter.spread(), Duration(500ms));
  clock.advance(1h);
  meter.arrived(clock.now(), 31s);
  EXPECT_EQ(meter.spread(), Duration(500ms)) << "the hour in between is none of it";
  clock.advance(31s);
  meter.arrived(clock.now(), 40ms);
  EXPECT_LT(*meter.spread(), 500ms);
}

TEST(JitterMeter, IsWhatAPlainSearchFinds) {
  aucast::test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 50; ++run) {
    ManualClock clock;
    JitterMeter meter;
    std::vector<std::pair<Instant, Duration>> all;
    const Instant begin = clock.now();
    Milliseconds media{0};
    Instant before = begin;
    for (int i = 0; i < 300; ++i, before = all.back().first) {
      const Milliseconds time(seeded.integer(0, 400));
      all.emplace_back(clock.now(), clock.now() - begin - media);
      meter.arrived(clock.now(), time);
      media += time;
      Duration low = Duration::max();
      Duration high = Duration::min();
      for (const auto& [at, lateness] : all) {
        if (before - at > JitterMeter::kWindow) continue;
        low = std::min(low, lateness);
        high = std::max(high, lateness);
      }
      ASSERT_EQ(meter.spread(), high - low);
      clock.advance(Milliseconds(seeded.integer(0, 600)));
    }
  }
}

}  // namespace
}  // namespace aucast::playback
