#include "client/playback/local_playback.h"

#include <functional>

#include <gtest/gtest.h>

#include "tests/support/manual_clock.h"

namespace aucast::playback {
namespace {

/// Three keyframes: 100, 200 and 300 ms.
class LocalPlaybackTest : public testing::Test {
 protected:
  [[nodiscard]] Duration at() const { return playback_.position(clock_.now()); }
  void go_on(Milliseconds time) { clock_.advance(time); }
  void play() { playback_.play(clock_.now()); }
  void seek(Milliseconds to) { playback_.seek(to, clock_.now()); }

  aucast::test::ManualClock clock_;
  LocalPlayback playback_{{Milliseconds(100), Milliseconds(200), Milliseconds(300)}};
};

TEST_F(LocalPlaybackTest, StandsAtTheBeginningUntilItIsPlayed) {
  go_on(Milliseconds(500));
  EXPECT_EQ(at(), Milliseconds(0));
  EXPECT_FALSE(playback_.over(clock_.now()));
  play();
  go_on(Milliseconds(150));
  EXPECT_EQ(at(), Milliseconds(150));
}

TEST_F(LocalPlaybackTest, APositionIsAFractionOfAKeyframe) {
  EXPECT_EQ(playback_.place(Milliseconds(0)), (StreamPlace{0, 0}));
  EXPECT_EQ(playback_.place(Milliseconds(50)), (StreamPlace{0, 0.5}));
  EXPECT_EQ(playback_.place(Milliseconds(100)), (StreamPlace{0, 1})) << "it is reached there";
  EXPECT_EQ(playback_.place(Milliseconds(250)), (StreamPlace{1, 0.75}));
  EXPECT_EQ(playback_.place(Milliseconds(600)), (StreamPlace{2, 1}));
}

TEST_F(LocalPlaybackTest, EndsWithTheLastKeyframeAndBeginsAnew) {
  play();
  go_on(Milliseconds(599));
  EXPECT_FALSE(playback_.over(clock_.now()));
  go_on(Milliseconds(5000));
  EXPECT_TRUE(playback_.over(clock_.now()));
  EXPECT_EQ(at(), Milliseconds(600));
  play();
  EXPECT_EQ(at(), Milliseconds(0));
  EXPECT_FALSE(playback_.over(clock_.now()));
}

TEST_F(LocalPlaybackTest, RepeatsTheWholeAndCountsEveryRound) {
  playback_.set_repeat(true, clock_.now());
  play();
  go_on(Milliseconds(1350));
  EXPECT_EQ(at(), Milliseconds(150));
  EXPECT_FALSE(playback_.over(clock_.now()));
  EXPECT_EQ(playback_.keyframes_played(clock_.now()), 7U);
  seek(Milliseconds(600));
  EXPECT_EQ(at(), Milliseconds(0)) << "the end is the beginning";
}

TEST_F(LocalPlaybackTest, WhatHasEndedBeginsAnewWhenItIsToBeRepeated) {
  play();
  go_on(Milliseconds(5000));
  playback_.set_repeat(true, clock_.now());
  go_on(Milliseconds(50));
  EXPECT_EQ(at(), Milliseconds(50));
}

TEST_F(LocalPlaybackTest, PauseHoldsAndPlayGoesOnFromThere) {
  play();
  go_on(Milliseconds(70));
  playback_.pause(clock_.now());
  go_on(Milliseconds(1000));
  EXPECT_EQ(at(), Milliseconds(70));
  play();
  go_on(Milliseconds(10));
  EXPECT_EQ(at(), Milliseconds(80));
}

TEST_F(LocalPlaybackTest, WhatHasPlayedToItsEndStandsWhereItIsSought) {
  playback_.play(clock_.now());
  clock_.advance(Milliseconds(9000));
  ASSERT_TRUE(playback_.over(clock_.now()));
  seek(Milliseconds(200));
  EXPECT_FALSE(playback_.playing());
  EXPECT_EQ(playback_.position(clock_.now()), Milliseconds(200));
  // A drag to the end and back does not end playing.
  playback_.play(clock_.now());
  seek(Milliseconds(9000));
  seek(Milliseconds(200));
  EXPECT_TRUE(playback_.playing());
}

TEST_F(LocalPlaybackTest, WhatIsSetAfterTheEndDoesNotMakeASeekPlay) {
  const auto set_speed = [this] { playback_.set_speed(50, clock_.now()); };
  const auto mark = [this] { playback_.mark_loop(clock_.now()); };
  const auto no_repeat = [this] { playback_.set_repeat(false, clock_.now()); };
  for (const std::function<void()>& set : {std::function<void()>(set_speed), {mark}, {no_repeat}}) {
    playback_.play(clock_.now());
    clock_.advance(Milliseconds(9000));
    set();
    set();
    ASSERT_TRUE(playback_.over(clock_.now()));
    seek(Milliseconds(200));
    EXPECT_FALSE(playback_.playing());
  }
  // The end of a drag is not where playing came to.
  playback_.play(clock_.now());
  seek(Milliseconds(9000));
  set_speed();
  seek(Milliseconds(200));
  EXPECT_TRUE(playback_.playing());
}

TEST_F(LocalPlaybackTest, SeekKeepsPlayingAndStaysInside) {
  play();
  seek(Milliseconds(400));
  go_on(Milliseconds(50));
  EXPECT_EQ(at(), Milliseconds(450));
  seek(Milliseconds(-5));
  EXPECT_EQ(at(), Milliseconds(0));
  seek(Milliseconds(9000));
  EXPECT_TRUE(playback_.over(clock_.now()));
}

TEST_F(LocalPlaybackTest, StepsByKeyframeGoToTheNextFaceThatIsReached) {
  play();
  go_on(Milliseconds(50));
  playback_.step_keyframe(+1, clock_.now());
  EXPECT_EQ(at(), Milliseconds(100));
  EXPECT_FALSE(playback_.playing());
  playback_.step_keyframe(+1, clock_.now());
  EXPECT_EQ(at(), Milliseconds(300));
  playback_.step_keyframe(+1, clock_.now());
  playback_.step_keyframe(+1, clock_.now());
  EXPECT_EQ(at(), Milliseconds(600));
  playback_.step_keyframe(-1, clock_.now());
  EXPECT_EQ(at(), Milliseconds(300));
  seek(Milliseconds(299));
  playback_.step_keyframe(-1, clock_.now());
  EXPECT_EQ(at(), Milliseconds(100));
  playback_.step_keyframe(-1, clock_.now());
  playback_.step_keyframe(-1, clock_.now());
  EXPECT_EQ(at(), Milliseconds(0));
}

TEST_F(LocalPlaybackTest, AStepByFrameIsAPictureOfAVideoHoweverLongTheKeyframes) {
  const auto step = [this](int direction) { playback_.step_at_rate(direction, 25, clock_.now()); };
  step(-1);
  EXPECT_EQ(at(), Milliseconds(0));
  step(+1);
  EXPECT_EQ(at(), Milliseconds(40));
  step(+1);
  step(+1);
  EXPECT_EQ(at(), Milliseconds(120)) << "a keyframe ends at 100";
  step(-1);
  step(-1);
  EXPECT_EQ(at(), Milliseconds(40));
  seek(Milliseconds(43));
  step(-1);
  EXPECT_EQ(at(), Milliseconds(40));
  seek(Milliseconds(43));
  step(+1);
  EXPECT_EQ(at(), Milliseconds(80));
}

TEST_F(LocalPlaybackTest, TheLastStepByFrameIsToTheEnd) {
  seek(Milliseconds(599));
  playback_.step_at_rate(+1, 25, clock_.now());
  EXPECT_EQ(at(), Milliseconds(600));
  playback_.step_at_rate(+1, 25, clock_.now());
  EXPECT_EQ(at(), Milliseconds(600));
  playback_.step_at_rate(-1, 25, clock_.now());
  EXPECT_EQ(at(), Milliseconds(560));
}

TEST_F(LocalPlaybackTest, StepsByFrameMissNoPictureOfARateThatMillisecondsDoNotDivide) {
  for (int i = 1; i <= 18; ++i) playback_.step_at_rate(+1, 30, clock_.now());
  EXPECT_EQ(at(), Milliseconds(600));
  for (int i = 1; i <= 17; ++i) playback_.step_at_rate(-1, 30, clock_.now());
  EXPECT_EQ(at(), Duration(std::chrono::seconds(1)) / 30);
}

TEST_F(LocalPlaybackTest, SpeedChangesFromWhereItIs) {
  play();
  go_on(Milliseconds(100));
  playback_.set_speed(200, clock_.now());
  EXPECT_EQ(at(), Milliseconds(100));
  go_on(Milliseconds(100));
  EXPECT_EQ(at(), Milliseconds(300));
  playback_.set_speed(1, clock_.now());
  EXPECT_EQ(playback_.speed_percent(), LocalPlayback::kSpeedMin);
  go_on(Milliseconds(100));
  EXPECT_EQ(at(), Milliseconds(310));
  playback_.set_speed(100'000, clock_.now());
  EXPECT_EQ(playback_.speed_percent(), LocalPlayback::kSpeedMax);
}

TEST_F(LocalPlaybackTest, SpeedStepsReachBothLimitsAndOne) {
  playback_.change_speed(+1, clock_.now());
  EXPECT_EQ(playback_.speed_percent(), 125);
  playback_.set_speed(110, clock_.now());
  playback_.change_speed(-1, clock_.now());
  EXPECT_EQ(playback_.speed_percent(), 100);
  for (int i = 0; i < 20; ++i) playback_.change_speed(-1, clock_.now());
  EXPECT_EQ(playback_.speed_percent(), 10);
  for (int i = 0; i < 20; ++i) playback_.change_speed(+1, clock_.now());
  EXPECT_EQ(playback_.speed_percent(), 1000);
}

TEST_F(LocalPlaybackTest, ALoopGoesRoundBetweenItsMarks) {
  play();
  go_on(Milliseconds(100));
  playback_.mark_loop(clock_.now());
  go_on(Milliseconds(150));
  playback_.mark_loop(clock_.now());
  EXPECT_EQ(at(), Milliseconds(100));
  EXPECT_EQ(playback_.loop_begin(), Milliseconds(100));
  EXPECT_EQ(playback_.loop_end(), Milliseconds(250));
  go_on(Milliseconds(40));
  EXPECT_EQ(at(), Milliseconds(140));
  go_on(Milliseconds(1500));
  EXPECT_EQ(at(), Milliseconds(140));
  playback_.mark_loop(clock_.now());
  EXPECT_FALSE(playback_.loop_begin().has_value());
  go_on(Milliseconds(1500));
  EXPECT_TRUE(playback_.over(clock_.now()));
}

TEST_F(LocalPlaybackTest, ALoopMarkedBackwardsIsTheSameLoop) {
  seek(Milliseconds(300));
  playback_.mark_loop(clock_.now());
  playback_.mark_loop(clock_.now());
  EXPECT_FALSE(playback_.loop_begin().has_value()) << "nothing lies between a mark and itself";
  playback_.mark_loop(clock_.now());
  seek(Milliseconds(100));
  playback_.mark_loop(clock_.now());
  EXPECT_EQ(playback_.loop_begin(), Milliseconds(100));
  EXPECT_EQ(playback_.loop_end(), Milliseconds(300));
  EXPECT_EQ(at(), Milliseconds(100));
}

TEST_F(LocalPlaybackTest, BehindALoopItPlaysToTheEnd) {
  playback_.mark_loop(clock_.now());
  seek(Milliseconds(200));
  playback_.mark_loop(clock_.now());
  seek(Milliseconds(250));
  play();
  go_on(Milliseconds(1000));
  EXPECT_TRUE(playback_.over(clock_.now()));
}

TEST_F(LocalPlaybackTest, ThePositionDoesNotDependOnHowOftenOneAsks) {
  LocalPlayback often{{Milliseconds(100), Milliseconds(200), Milliseconds(300)}};
  playback_.set_speed(33, clock_.now());
  often.set_speed(33, clock_.now());
  play();
  often.play(clock_.now());
  for (int i = 0; i < 777; ++i) {
    clock_.advance(std::chrono::microseconds(997));
    static_cast<void>(often.position(clock_.now()));
    static_cast<void>(often.keyframes_played(clock_.now()));
  }
  EXPECT_EQ(often.position(clock_.now()), at());
}

TEST_F(LocalPlaybackTest, CountsWhatWasPlayedAndNotWhatWasSkipped) {
  play();
  go_on(Milliseconds(150));
  EXPECT_EQ(playback_.keyframes_played(clock_.now()), 1U);
  seek(Milliseconds(350));
  EXPECT_EQ(playback_.keyframes_played(clock_.now()), 1U);
  go_on(Milliseconds(1000));
  EXPECT_EQ(playback_.keyframes_played(clock_.now()), 2U);
  EXPECT_EQ(playback_.media_time(clock_.now()), Milliseconds(400));
  playback_.pause(clock_.now());
  playback_.pause(clock_.now());
  EXPECT_EQ(playback_.keyframes_played(clock_.now()), 2U);
}

TEST_F(LocalPlaybackTest, RoundsOfALoopCount) {
  seek(Milliseconds(50));
  playback_.mark_loop(clock_.now());
  seek(Milliseconds(150));
  playback_.mark_loop(clock_.now());
  EXPECT_EQ(at(), Milliseconds(50));
  play();
  go_on(Milliseconds(1000));
  EXPECT_EQ(playback_.keyframes_played(clock_.now()), 10U);
}

TEST(LocalPlaybackJumps, WherePicturesAreMissingStepsAreAsLongAsElsewhere) {
  aucast::test::ManualClock clock;
  std::vector<Milliseconds> times(20, Milliseconds(40));
  times[1] = Milliseconds(121);  // two pictures without a face
  LocalPlayback playback(times);
  ASSERT_EQ(playback.picture_time(), Milliseconds(40));
  std::vector<Duration> on;
  for (int i = 0; i < 5; ++i) {
    playback.step_picture(+1, clock.now());
    on.push_back(playback.position(clock.now()));
  }
  EXPECT_EQ(on, (std::vector<Duration>{Milliseconds(40), Milliseconds(80), Milliseconds(120),
                                       Milliseconds(161), Milliseconds(201)}));
  for (std::size_t i = on.size() - 1; i-- > 0;) {
    playback.step_picture(-1, clock.now());
    EXPECT_EQ(playback.position(clock.now()), on[i]) << i;
  }
  playback.step_picture(-1, clock.now());
  playback.step_picture(-1, clock.now());
  EXPECT_EQ(playback.position(clock.now()), Duration::zero());
}

TEST(LocalPlaybackJumps, KeyframesOfNoTimeArePassedOver) {
  aucast::test::ManualClock clock;
  LocalPlayback playback({Milliseconds(0), Milliseconds(100), Milliseconds(0)});
  EXPECT_EQ(playback.place(Milliseconds(0)), (StreamPlace{0, 1}));
  EXPECT_EQ(playback.place(Milliseconds(100)), (StreamPlace{2, 1}));
  playback.play(clock.now());
  clock.advance(Milliseconds(200));
  EXPECT_TRUE(playback.over(clock.now()));
  EXPECT_EQ(playback.keyframes_played(clock.now()), 3U);
}

TEST(LocalPlaybackJumps, AStreamOfNoTimeIsItsLastFace) {
  aucast::test::ManualClock clock;
  LocalPlayback playback({Milliseconds(0), Milliseconds(0)});
  playback.play(clock.now());
  EXPECT_TRUE(playback.over(clock.now()));
  EXPECT_EQ(playback.place(playback.position(clock.now())), (StreamPlace{1, 1}));
  playback.step_at_rate(+1, 25, clock.now());
  playback.step_keyframe(-1, clock.now());
  EXPECT_EQ(playback.position(clock.now()), Milliseconds(0));
}

}  // namespace
}  // namespace aucast::playback
