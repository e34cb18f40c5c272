#include "client/sound/heard_line.h"

#include <gtest/gtest.h>

#include <cmath>

namespace aucast::sound {
namespace {

using std::chrono::microseconds;

const Instant kBegin{std::chrono::hours(1)};

/// What a device says that takes its sound in portions of 30 ms.
Duration saw_tooth(Duration true_time) {
  return true_time - true_time % Milliseconds(30) + Milliseconds(15);
}

TEST(HeardLine, StandsUntilTheDeviceHasHeardSomething) {
  HeardLine line;
  for (int ms = 0; ms < 2000; ms += 10) {
    line.add(kBegin + Milliseconds(ms), {});
    EXPECT_EQ(line.at(kBegin + Milliseconds(ms)), Duration::zero());
  }
  line.add(kBegin + Milliseconds(2000), Milliseconds(7));
  EXPECT_EQ(line.at(kBegin + Milliseconds(2000)), Milliseconds(7));
  EXPECT_EQ(line.at(kBegin + Milliseconds(2003)), Milliseconds(10));
}

TEST(HeardLine, StaysWithin5MsOfADeviceThatLeapsBy30) {
  HeardLine line;
  Duration last{};
  for (int ms = 1; ms < 20'000; ms += 7) {
    const Instant now = kBegin + Milliseconds(ms);
    line.add(now, saw_tooth(Milliseconds(ms)));
    const Duration heard = line.at(now);
    EXPECT_GE(heard, last);
    last = heard;
    if (ms > 1500) {
      EXPECT_LE(std::abs(seconds(heard - Milliseconds(ms))), 0.005) << ms;
    }
  }
}

TEST(HeardLine, RunsEvenly) {
  HeardLine line;
  Duration last{};
  for (int ms = 1; ms < 5'000; ms += 10) {
    const Instant now = kBegin + Milliseconds(ms);
    line.add(now, saw_tooth(Milliseconds(ms)));
    const Duration heard = line.at(now);
    if (ms > 1500) {
      EXPECT_NEAR(seconds(heard - last), 0.010, 0.00011) << ms;
    }
    last = heard;
  }
}

TEST(HeardLine, TellsTheDriftOfTheDevice) {
  HeardLine line;
  EXPECT_FALSE(line.drift_ppm().has_value());
  for (int ms = 1; ms < 60'000; ms += 10) {
    const Instant now = kBegin + Milliseconds(ms);
    line.add(now, microseconds(ms * 1000 + ms / 10));  // 100 parts of a million
    (void)line.at(now);
  }
  ASSERT_TRUE(line.drift_ppm().has_value());
  EXPECT_NEAR(*line.drift_ppm(), 100, 5);
  EXPECT_NEAR(seconds(line.at(kBegin + Milliseconds(59'991))), 59.991 + 0.0059991, 0.0002);
}

TEST(HeardLine, FollowsALeapAtOnceAndNeverGoesBack) {
  HeardLine line;
  Duration heard{};
  const auto run = [&](int from_ms, int to_ms, int wrong_ms) {
    for (int ms = from_ms; ms < to_ms; ms += 10) {
      const Instant now = kBegin + Milliseconds(ms);
      line.add(now, Milliseconds(ms + wrong_ms));
      const Duration next = line.at(now);
      EXPECT_GE(next, heard);
      heard = next;
    }
  };
  run(10, 2000, 0);
  run(2000, 2100, 500);
  EXPECT_NEAR(seconds(heard), 2.590, 0.003);
  run(2100, 4000, -500);
  EXPECT_NEAR(seconds(heard), 3.490, 0.003);
}

TEST(HeardLine, StandsWhereItIsWhenToldThatTheDeviceStands) {
  HeardLine line;
  for (int ms = 10; ms <= 1000; ms += 10) {
    line.add(kBegin + Milliseconds(ms), Milliseconds(ms));
    (void)line.at(kBegin + Milliseconds(ms));
  }
  line.begin_again();
  for (int ms = 1010; ms <= 1500; ms += 10) {
    line.add(kBegin + Milliseconds(ms), Milliseconds(1000));
    EXPECT_EQ(line.at(kBegin + Milliseconds(ms)), Milliseconds(1000));
  }
  line.add(kBegin + Milliseconds(1510), Milliseconds(1010));
  EXPECT_EQ(line.at(kBegin + Milliseconds(1520)), Milliseconds(1020));
}

}  // namespace
}  // namespace aucast::sound
