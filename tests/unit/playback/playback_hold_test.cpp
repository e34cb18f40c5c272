// What the playback does when nothing comes: hold, ease to neutral, and go on without a jump.
#include <cmath>

#include <gtest/gtest.h>

#include "client/playback/interpolator.h"
#include "client/playback/source_playback.h"
#include "tests/support/manual_clock.h"
#include "tests/unit/playback/marked.h"
#include "tests/unit/playback/scripted_source.h"

namespace aucast::playback {
namespace {

using namespace std::chrono_literals;
using test::borrow;
using test::marked;
using test::ScriptedSource;

class Holding : public ::testing::Test {
 protected:
  Holding() {
    source_.keyframes = {marked(1, 100ms)};
    EXPECT_TRUE(advance(0ms));
    EXPECT_FALSE(advance(100ms));
    EXPECT_EQ(playback_.state(), PlaybackState::Stalled);
  }

  std::optional<KeyframeBegun> advance(Duration by) {
    clock_.advance(by);
    return playback_.advance(clock_.now());
  }

  aucast::test::ManualClock clock_;
  ScriptedSource source_;
  SourcePlayback playback_{borrow(source_), {.hold = 5s}};
};

TEST_F(Holding, EasesToNeutralAfterTheHold) {
  EXPECT_FALSE(advance(4999ms));
  EXPECT_EQ(playback_.progress().mu, 1.0) << "it holds";
  const auto easing = advance(1ms);
  ASSERT_TRUE(easing);
  EXPECT_EQ(easing->target.aus, AuFrame{});
  EXPECT_EQ(easing->time, SourcePlayback::kEaseTime);
  EXPECT_EQ(easing->cut_at, 1.0);
  EXPECT_EQ(playback_.state(), PlaybackState::Stale);
  EXPECT_EQ(playback_.progress().mu, 0.0);
  EXPECT_FALSE(advance(250ms));
  EXPECT_EQ(playback_.progress().mu, 0.25);
  EXPECT_FALSE(advance(1h));
  EXPECT_EQ(playback_.progress().mu, 1.0);
  EXPECT_EQ(playback_.state(), PlaybackState::Stale);
  EXPECT_EQ(playback_.keyframes_played(), 1U) << "the easing is none";
  EXPECT_EQ(playback_.stalls(), 1U);
  EXPECT_EQ(playback_.media_time(), 100ms);
}

TEST_F(Holding, GoesOnFromWhereTheEasingWas) {
  EXPECT_TRUE(advance(5s));
  source_.keyframes = {marked(2, 100ms)};
  const auto next = advance(300ms);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->cut_at, 0.3);
  EXPECT_EQ(playback_.state(), PlaybackState::Playing);
  EXPECT_EQ(playback_.progress().mu, 0.0);
  EXPECT_FALSE(advance(100ms));
  EXPECT_EQ(playback_.keyframes_played(), 2U);
}

TEST_F(Holding, GoesOnFromTheHeldFaceBeforeThat) {
  EXPECT_FALSE(advance(4s));
  source_.keyframes = {marked(2, 100ms)};
  EXPECT_EQ(advance(0ms)->cut_at, 1.0);
}

TEST_F(Holding, APauseStopsTheHoldToo) {
  EXPECT_FALSE(advance(4s));
  playback_.pause(clock_.now());
  EXPECT_FALSE(advance(1h));
  playback_.resume(clock_.now());
  EXPECT_FALSE(advance(999ms));
  EXPECT_EQ(playback_.state(), PlaybackState::Stalled);
  EXPECT_TRUE(advance(1ms));
}

TEST_F(Holding, FollowingNextPositionMeetsEveryPositionOfTheEasingOnce) {
  ASSERT_TRUE(advance(5s));
  for (int k = 1; k <= kPositionsPerKeyframe; ++k) {
    ASSERT_EQ(playback_.next_position_at(), clock_.now() + 20ms);
    EXPECT_FALSE(advance(20ms));
    EXPECT_EQ(playback_.progress().position, k);
    EXPECT_EQ(playback_.progress().mu, k / 50.0);
  }
  EXPECT_FALSE(playback_.next_position_at());
}

TEST_F(Holding, APauseHoldsTheEasingWhereItIs) {
  ASSERT_TRUE(advance(5s));
  EXPECT_FALSE(advance(300ms));
  clock_.advance(10ms);
  playback_.pause(clock_.now());
  EXPECT_EQ(playback_.progress().mu, 0.31) << "as of the pause, not as of the last look";
  EXPECT_FALSE(playback_.next_position_at());
  EXPECT_FALSE(advance(1h));
  EXPECT_EQ(playback_.progress().mu, 0.31);
  playback_.resume(clock_.now());
  EXPECT_EQ(playback_.progress().mu, 0.31);
  EXPECT_EQ(playback_.next_position_at(), clock_.now() + 10ms);
  EXPECT_FALSE(advance(90ms));
  EXPECT_EQ(playback_.progress().mu, 0.4);
  EXPECT_EQ(playback_.state(), PlaybackState::Stale);
}

TEST_F(Holding, StoppingHoldsTheEasingWhereItIs) {
  ASSERT_TRUE(advance(5s));
  EXPECT_FALSE(advance(300ms));
  clock_.advance(10ms);
  playback_.stop(clock_.now());
  EXPECT_EQ(playback_.progress().mu, 0.31);
  EXPECT_FALSE(advance(1h));
  EXPECT_EQ(playback_.progress().mu, 0.31);
  EXPECT_TRUE(playback_.eased());
}

TEST_F(Holding, NeverWithoutAHold) {
  SourcePlayback other(borrow(source_), {});
  source_.keyframes = {marked(1, 100ms)};
  EXPECT_TRUE(other.advance(clock_.now()));
  clock_.advance(100h);
  EXPECT_FALSE(other.advance(clock_.now()));
  clock_.advance(100h);
  EXPECT_FALSE(other.advance(clock_.now()));
  EXPECT_EQ(other.state(), PlaybackState::Stalled);
}

TEST_F(Holding, ALossIsHeldAndEasedAsWell) {
  EXPECT_FALSE(advance(3s));
  source_.now.end = EndReason::ConnectionLost;
  EXPECT_FALSE(advance(0s));
  EXPECT_EQ(playback_.state(), PlaybackState::Lost);
  EXPECT_FALSE(playback_.eased());
  EXPECT_FALSE(advance(1999ms)) << "five seconds since something came";
  EXPECT_FALSE(playback_.next_position_at());
  const auto easing = advance(1ms);
  ASSERT_TRUE(easing);
  EXPECT_EQ(easing->target.aus, AuFrame{});
  EXPECT_EQ(playback_.state(), PlaybackState::Lost) << "it remains what it is";
  EXPECT_TRUE(playback_.over());
  EXPECT_TRUE(playback_.eased());
  EXPECT_EQ(playback_.next_position_at(), clock_.now() + 20ms);
  EXPECT_FALSE(advance(500ms));
  EXPECT_EQ(playback_.progress().mu, 0.5);
  EXPECT_FALSE(advance(1h));
  EXPECT_EQ(playback_.progress().mu, 1.0);
  EXPECT_FALSE(playback_.next_position_at());
  EXPECT_EQ(playback_.keyframes_played(), 1U);
}

TEST_F(Holding, ALossWithinTheEasingEndsTheEasingFirst) {
  EXPECT_TRUE(advance(5s));
  source_.now.end = EndReason::ConnectionLost;
  EXPECT_FALSE(advance(400ms));
  EXPECT_EQ(playback_.state(), PlaybackState::Lost);
  EXPECT_EQ(playback_.progress().mu, 0.4);
  EXPECT_FALSE(advance(300ms));
  EXPECT_EQ(playback_.progress().mu, 0.7);
}

TEST_F(Holding, WhatEndedWellStaysAsItIs) {
  source_.now.end = EndReason::EndOfStream;
  EXPECT_FALSE(advance(0s));
  EXPECT_FALSE(advance(1h));
  EXPECT_EQ(playback_.state(), PlaybackState::Ended);
  EXPECT_FALSE(playback_.eased());
}

TEST(HoldingNothing, ALossBeforeTheFirstKeyframeMovesNothing) {
  aucast::test::ManualClock clock;
  ScriptedSource source;
  source.now.end = EndReason::Unreachable;
  SourcePlayback playback(borrow(source), {.hold = 5s});
  EXPECT_FALSE(playback.advance(clock.now()));
  EXPECT_EQ(playback.state(), PlaybackState::Lost);
  clock.advance(1h);
  EXPECT_FALSE(playback.advance(clock.now()));
}

/// The face never moves faster than from one keyframe to the next within a keyframe's time: no
/// frame jumps, whenever the stream breaks off and comes again.
TEST_F(Holding, NoFrameJumps) {
  float shown = 1;
  float from = 1;
  float to = 1;
  const auto frame = [&] {
    clock_.advance(10ms);
    while (const auto begun = playback_.advance(clock_.now())) {
      from += (to - from) * static_cast<float>(begun->cut_at);
      to = begun->target.aus.left[1];
    }
    const float next = from + (to - from) * static_cast<float>(playback_.progress().mu);
    EXPECT_LE(std::abs(next - shown), 0.11F);
    shown = next;
  };
  for (int round = 0; round < 40; ++round) {
    for (int i = 0; i < 470 + round * 7; ++i) frame();
    source_.keyframes = {marked(round % 2, 100ms), marked(1, 100ms)};
  }
  EXPECT_GT(playback_.keyframes_played(), 70U);
}

}  // namespace
}  // namespace aucast::playback
