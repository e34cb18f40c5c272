// Where in the stream playing is: what the sound goes by.

#include "client/playback/passing.h"

#include <gtest/gtest.h>

#include "client/playback/seekable_playback.h"
#include "client/playback/source_playback.h"
#include "tests/support/manual_clock.h"
#include "tests/unit/playback/marked.h"
#include "tests/unit/playback/scripted_source.h"

namespace aucast::playback {
namespace {

using namespace std::chrono_literals;
using aucast::test::ManualClock;
using test::marked;
using test::ScriptedSource;

class PassingTest : public ::testing::Test {
 protected:
  PassingTest() {
    auto source = std::make_unique<ScriptedSource>();
    source_ = source.get();
    playback_ = std::make_unique<SourcePlayback>(std::move(source), SourcePlayback::Options{});
  }

  void keyframe(Milliseconds place, Milliseconds time = 100ms, int pace = 100) {
    Keyframe keyframe = marked(1, time);
    keyframe.place = place;
    keyframe.span = time;
    keyframe.pace_percent = pace;
    source_->keyframes.push_back(keyframe);
  }
  Passing after(Duration time) {
    clock_.advance(time);
    while (playback_->advance(clock_.now())) {
    }
    return playback_->passing().value_or(Passing{-1s, -1});
  }

  ManualClock clock_;
  ScriptedSource* source_ = nullptr;
  std::unique_ptr<SourcePlayback> playback_;
};

TEST_F(PassingTest, NothingIsKnownBeforeTheFirstPlace) {
  EXPECT_EQ(after(0ms).place, -1s);
  source_->keyframes.push_back(marked(1, 100ms));
  EXPECT_EQ(after(10ms).place, -1s);
}

TEST_F(PassingTest, RunsAndStandsWithTheFace) {
  keyframe(1100ms);
  keyframe(1200ms);
  EXPECT_EQ(after(0ms).place, 1000ms);
  EXPECT_EQ(after(30ms).place, 1030ms);
  EXPECT_EQ(after(100ms).place, 1130ms);
  EXPECT_EQ(after(0ms).speed, 1);
  playback_->pause(clock_.now());
  EXPECT_EQ(after(500ms).speed, 0);
  EXPECT_EQ(after(0ms).place, 1130ms) << "where the face stands";
  playback_->resume(clock_.now());
  EXPECT_EQ(after(20ms).place, 1150ms);
  EXPECT_EQ(after(100ms).place, 1200ms) << "a stall";
  EXPECT_EQ(after(100ms).speed, 0);
  keyframe(2000ms);
  EXPECT_EQ(after(10ms).place, 1900ms) << "what was left out is leapt over";
}

TEST_F(PassingTest, StandsWhereThePlayerWasStopped) {
  keyframe(200ms, 200ms);
  source_->keyframes.back().span = 100ms;
  (void)after(0ms);
  (void)after(50ms);
  playback_->stop(clock_.now());
  EXPECT_EQ(after(500ms).place, 125ms);
  EXPECT_EQ(after(0ms).speed, 0);
}

TEST_F(PassingTest, StandsWhereThePlayerWasStoppedWhilePaused) {
  keyframe(200ms, 200ms);
  (void)after(0ms);
  (void)after(50ms);
  playback_->pause(clock_.now());
  (void)after(50ms);
  playback_->stop(clock_.now());
  EXPECT_EQ(after(500ms).place, 50ms);
}

TEST_F(PassingTest, GoesOnAfterTheEnd) {
  keyframe(100ms);
  source_->now.end = EndReason::EndOfStream;
  (void)after(0ms);
  const Passing passing = after(350ms);
  EXPECT_EQ(passing.place, 350ms);
  EXPECT_EQ(passing.speed, 1);
}

TEST_F(PassingTest, StandsWhereAConnectionWasLost) {
  keyframe(100ms);
  source_->now.end = EndReason::ConnectionLost;
  (void)after(0ms);
  EXPECT_EQ(after(350ms).place, 100ms);
  EXPECT_EQ(after(0ms).speed, 0);
}

TEST_F(PassingTest, AKeyframeThatIsPlayedFasterPassesFaster) {
  keyframe(190ms, 190ms, 95);
  (void)after(0ms);
  const Passing passing = after(95ms);
  EXPECT_NEAR(passing.speed, 1 / 0.95, 1e-9);
  EXPECT_EQ(passing.place, 100ms);
}

TEST_F(PassingTest, AKeyframeThatIsGivenMoreTimePassesItsPartOfTheStreamSlower) {
  keyframe(200ms, 200ms);
  source_->keyframes.back().span = 100ms;
  keyframe(300ms, 200ms);
  source_->keyframes.back().span = 100ms;
  (void)after(0ms);
  EXPECT_EQ(after(50ms).place, 125ms);
  EXPECT_EQ(after(0ms).speed, 0.5);
  EXPECT_EQ(after(150ms).place, 200ms) << "no part of it passes twice";
}

TEST_F(PassingTest, WhileSomebodySpeaksPlayingBendsByHalfAPercent) {
  for (const int pace : {95, 105}) {
    keyframe(1000ms, 1000ms, pace);
    source_->keyframes.back().spoken = true;
    keyframe(1100ms);
    (void)after(2000ms);
    const std::uint64_t before = playback_->keyframes_played();
    (void)after(0ms);
    keyframe(2000ms, 1000ms, pace);
    source_->keyframes.back().spoken = true;
    keyframe(2100ms);
    (void)after(0ms);
    const Duration whole = pace < 100 ? 995ms : 1005ms;
    (void)after(whole - 1ms);
    EXPECT_EQ(playback_->keyframes_played(), before);
    (void)after(1ms);
    EXPECT_EQ(playback_->keyframes_played(), before + 1);
    (void)after(1s);
  }
}

TEST_F(PassingTest, ALiveKeyframeIsDueByTheClockThatIsHandedIn) {
  keyframe(1000ms, 1000ms);
  source_->keyframes.back().arrived = clock_.now();
  source_->keyframes.back().due = clock_.now() + 1s;
  playback_->set_clock(20ms, 100ms);
  (void)after(0ms);
  keyframe(1100ms);
  (void)after(1019ms);
  EXPECT_EQ(playback_->keyframes_played(), 0U);
  (void)after(1ms);
  EXPECT_EQ(playback_->keyframes_played(), 1U);
  EXPECT_EQ(playback_->delays().all().median, 1100ms) << "shown 100 ms after the moment handed in";
}

TEST(SeekablePassing, IsThePositionAndTheSpeed) {
  SeekablePlayback playback({marked(1, 1000ms), marked(2, 1000ms)}, 250ms);
  ManualClock clock;
  const auto after = [&](Duration time) {
    clock.advance(time);
    while (playback.advance(clock.now())) {
    }
    return *playback.passing();
  };
  EXPECT_EQ(after(0ms).place, 0ms);
  EXPECT_EQ(after(100ms).place, 100ms);
  EXPECT_EQ(after(0ms).speed, 1);
  playback.playhead(clock.now()).set_speed(200, clock.now());
  EXPECT_EQ(after(100ms).place, 300ms);
  EXPECT_EQ(after(0ms).speed, 2);
  playback.playhead(clock.now()).seek(1500ms, clock.now());
  EXPECT_EQ(after(0ms).place, 1500ms);
  playback.pause(clock.now());
  EXPECT_EQ(after(100ms).speed, 0);
  playback.resume(clock.now());
  EXPECT_EQ(after(5s).speed, 0) << "at the end";
}

}  // namespace
}  // namespace aucast::playback
