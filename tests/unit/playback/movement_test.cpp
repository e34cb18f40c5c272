#include "client/playback/movement.h"

#include <gtest/gtest.h>

#include "tests/support/manual_clock.h"
#include "tests/support/seeded.h"

namespace aucast::playback {
namespace {

using namespace std::chrono_literals;
using aucast::test::ManualClock;
using aucast::test::Seeded;

TEST(Movement, StandsBeforeItBeginsAndAfterItHasEnded) {
  const Instant begin = ManualClock().now();
  const Movement movement{begin, 100ms};
  EXPECT_EQ(movement.position(begin - 1h), 0);
  EXPECT_EQ(movement.mu(begin - 1h), 0.0);
  EXPECT_EQ(movement.position(begin + 1h), kPositionsPerKeyframe);
  EXPECT_EQ(movement.mu(begin + 1h), 1.0);
  EXPECT_EQ(movement.end(), begin + 100ms);
}

TEST(Movement, ThatTakesNoTimeHasAlwaysEnded) {
  const Instant begin = ManualClock().now();
  const Movement jump{begin, 0ms};
  for (const Instant at : {begin - 1ns, begin, begin + 1ns}) {
    EXPECT_EQ(jump.position(at), kPositionsPerKeyframe);
    EXPECT_EQ(jump.mu(at), 1.0);
  }
  EXPECT_EQ(jump.reaches(1), begin);
}

/// A double of 0.58 times 50 is less than 29.
TEST(Movement, ReachesEachPositionOfWholeMillisecondsExactly) {
  const Instant begin = ManualClock().now();
  for (int ms = 1; ms <= 1000; ++ms) {
    const Movement movement{begin, Milliseconds(ms)};
    for (int k = 1; k <= kPositionsPerKeyframe; ++k) {
      ASSERT_EQ(movement.position(movement.reaches(k)), k) << ms;
      ASSERT_EQ(movement.position(movement.reaches(k) - 1ns), k - 1) << ms;
    }
  }
}

TEST(Movement, NeverGoesBackAndIsNeverAheadOfItsFraction) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int round = 0; round < 300; ++round) {
    const Movement movement{ManualClock().now(), Duration(seeded.integer(1, 2'000'000'000))};
    Instant now = movement.begin - 10ms;
    int position = 0;
    double mu = 0;
    while (mu < 1) {
      now += Duration(seeded.integer(0, 30'000'000));
      ASSERT_GE(movement.position(now), position);
      ASSERT_GE(movement.mu(now), mu);
      position = movement.position(now);
      mu = movement.mu(now);
      ASSERT_LE(position, mu * kPositionsPerKeyframe + 1e-9);
      ASSERT_GT(position + 1, mu * kPositionsPerKeyframe - 1e-9);
      ASSERT_EQ(mu == 1, now >= movement.end());
    }
    EXPECT_EQ(position, kPositionsPerKeyframe);
  }
}

/// A pause shifts the begin by its length.
TEST(Movement, IsWhereItWasWhenItsBeginIsShifted) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int round = 0; round < 300; ++round) {
    Movement movement{ManualClock().now(), Duration(seeded.integer(1, 2'000'000'000))};
    const Instant now = movement.begin + Duration(seeded.integer(0, 2'000'000'000));
    const Movement before = movement;
    const Duration pause(seeded.integer(0, 2'000'000'000));
    movement.begin += pause;
    EXPECT_EQ(movement.position(now + pause), before.position(now));
    EXPECT_EQ(movement.mu(now + pause), before.mu(now));
    EXPECT_EQ(movement.passed(now + pause), before.passed(now));
  }
}

}  // namespace
}  // namespace aucast::playback
