#include "client/playback/live_playout.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/support/manual_clock.h"
#include "tests/support/seeded.h"

namespace aucast::playback {
namespace {

using namespace std::chrono_literals;
using aucast::test::ManualClock;
using aucast::test::Seeded;

/// What the programs add of their own; part of every delay.
constexpr Duration kMargin = 2ms;

/// A stream of 25 keyframes a second; each comes as late as it is told to.
class Playout : public ::testing::Test {
 protected:
  /// From the arrival of the next keyframe until it is due.
  Duration next(Duration late) {
    const Instant at = begin_ + late;
    begin_ += 40ms;
    return playout_.arrived(at, 40ms) - at;
  }
  void steady(int seconds) {
    for (int i = 0; i < 25 * seconds; ++i) next(0ms);
  }

  Instant begin_ = ManualClock().now();
  LivePlayout playout_;
};

TEST_F(Playout, WhatComesInTimeIsDueAfterItsOwnTime) {
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(next(0ms), 40ms + kMargin);
  EXPECT_EQ(playout_.delay(), 40ms + kMargin);
}

TEST_F(Playout, WhoJoinsWithinAKeyframeDoesNotTakeTheRestOfItForJitter) {
  next(30ms);
  next(0ms);
  EXPECT_EQ(next(0ms), 40ms + kMargin);
}

TEST_F(Playout, HoldsBackByWhatComesLateAgainAndAgain) {
  steady(1);
  for (int i = 0; i < 25 * 60; ++i) next(i % 25 == 7 ? 90ms : 0ms);
  EXPECT_EQ(next(0ms), 130ms + kMargin);
}

TEST_F(Playout, SitsOutWhatComesLateOnceInHalfAMinute) {
  steady(30);
  next(900ms);
  EXPECT_EQ(next(0ms), 40ms + kMargin);
  steady(10);
  next(900ms);
  EXPECT_EQ(next(0ms), 40ms + kMargin);
  steady(5);
  next(700ms);
  EXPECT_EQ(next(0ms), 740ms + kMargin) << "the third time it is the link";
}

TEST_F(Playout, HasNoDelayLessThanNone) {
  steady(30);
  for (int i = 0; i < 20; ++i) next(900ms);
  EXPECT_LT(next(900ms), 0ms) << "they are due at once";
  EXPECT_GE(playout_.delay(), 0ms);
}

TEST_F(Playout, ForgetsWhatWasAtTheBeginning) {
  next(0ms);
  next(500ms);
  EXPECT_EQ(next(0ms), 540ms + kMargin) << "nothing else is known";
  steady(1);
  EXPECT_EQ(next(0ms), 40ms + kMargin);
}

TEST_F(Playout, FollowsAClockThatHasStepped) {
  for (const Duration step : {Duration(10s), Duration(-3s)}) {
    steady(20);
    begin_ += std::max<Duration>(step, 0s);
    for (int i = 0; i < 50; ++i) next(std::min<Duration>(step, 0s));
    EXPECT_EQ(next(std::min<Duration>(step, 0s)), 40ms + kMargin);
    begin_ += std::min<Duration>(step, 0s);
  }
}

TEST_F(Playout, BeginsAgain) {
  steady(3);
  begin_ += 1h;
  playout_.begin_again();
  EXPECT_EQ(next(0ms), 40ms + kMargin);
}

TEST(PlayoutOfPlaces, SeesWhatWasLeftOutOnTheWay) {
  LivePlayout playout;
  Instant now = ManualClock().now();
  Milliseconds place = 1000s;
  for (int i = 0; i < 100; ++i) {
    const int steps = i % 10 == 9 ? 4 : 1;  // three are left out
    place += steps * 40ms;
    now += steps * 40ms;
    EXPECT_EQ(playout.arrived(now, 40ms, place) - now, 40ms + kMargin) << i;
  }
  place = 40ms;  // a loop
  EXPECT_EQ(playout.arrived(now + 40ms, 40ms, place) - (now + 40ms), 40ms + kMargin);
}

/// Of any jitter: hardly anything is late, and nothing is held longer than the jitter asks for.
TEST(PlayoutProperty, HoldsBackByTheJitterAndNoMore) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 50; ++run) {
    LivePlayout playout;
    const int jitter_us = seeded.integer(0, 80'000);
    const Milliseconds time(seeded.integer(10, 200));
    const Duration most = time + std::chrono::microseconds(jitter_us) + kMargin;
    Instant sent = ManualClock().now();
    Instant before = sent;
    int late = 0;
    constexpr int kCount = 5000;
    for (int i = 0; i < kCount; ++i, sent += time) {
      const Duration jitter = std::chrono::microseconds(seeded.integer(0, jitter_us));
      const Instant at = std::max(before, sent + jitter);
      before = at;
      const Duration delay = playout.arrived(at, time) - at;
      EXPECT_LE(delay, most + (i == 0 ? Duration(jitter_us * 1us) : Duration::zero()));
      if (delay < time) ++late;
    }
    EXPECT_LT(late, kCount / 50);
  }
}

}  // namespace
}  // namespace aucast::playback
