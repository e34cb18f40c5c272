#include "client/playback/source_playback.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/support/manual_clock.h"
#include "tests/unit/playback/marked.h"
#include "tests/unit/playback/scripted_source.h"

namespace aucast::playback {
namespace {

using namespace std::chrono_literals;
using aucast::test::ManualClock;
using test::borrow;
using test::mark_of;
using test::marked;
using test::ScriptedSource;

/// All keyframes that begin by `now`, by their marks.
std::vector<int> begun(SourcePlayback& playback, Instant now) {
  std::vector<int> marks;
  while (const auto keyframe = playback.advance(now)) {
    marks.push_back(mark_of(keyframe->target));
  }
  return marks;
}

using Marks = std::vector<int>;

TEST(SourcePlayback, WaitsForTheFirstKeyframe) {
  ManualClock clock;
  ScriptedSource source;
  SourcePlayback playback(borrow(source), {});
  EXPECT_EQ(begun(playback, clock.now()), Marks{});
  EXPECT_EQ(playback.state(), PlaybackState::Buffering);
  EXPECT_EQ(playback.progress().keyframe, 0U);
  EXPECT_FALSE(playback.next_position_at());

  clock.advance(3s);
  source.keyframes = {marked(1)};
  EXPECT_EQ(begun(playback, clock.now()), Marks{1});
  EXPECT_EQ(playback.state(), PlaybackState::Playing);
  EXPECT_EQ(playback.progress().keyframe, 1U);
  EXPECT_EQ(playback.progress().position, 0);
  EXPECT_EQ(playback.stalls(), 0U) << "waiting for the first is no stall";
}

TEST(SourcePlayback, ReachesFiftyPositionsByTheClock) {
  ManualClock clock;
  ScriptedSource source;
  source.keyframes = {marked(1, 250ms)};
  SourcePlayback playback(borrow(source), {});
  EXPECT_EQ(begun(playback, clock.now()), Marks{1});
  for (int k = 0; k < kPositionsPerKeyframe; ++k) {
    EXPECT_EQ(playback.progress().position, k);
    EXPECT_EQ(playback.progress().mu, k / 50.0);
    ASSERT_EQ(playback.next_position_at(), clock.now() + 5ms);
    clock.advance(5ms - 1ns);
    EXPECT_EQ(begun(playback, clock.now()), Marks{});
    EXPECT_EQ(playback.progress().position, k) << "a nanosecond before";
    clock.advance(1ns);
    EXPECT_EQ(begun(playback, clock.now()), Marks{});
  }
  EXPECT_EQ(playback.progress().position, 50);
  EXPECT_EQ(playback.progress().mu, 1.0);
}

TEST(SourcePlayback, TakesAKeyframesTimeFromPacketSpeedServerInThisOrder) {
  ManualClock clock;
  ScriptedSource source;
  source.now.keyframe_time = 70ms;
  const auto time_of = [&](std::optional<Milliseconds> speed, std::optional<Milliseconds> own) {
    source.keyframes = {marked(1, own)};
    SourcePlayback playback(borrow(source), {.speed = speed});
    const auto keyframe = playback.advance(clock.now());
    return keyframe ? keyframe->time : -1ms;
  };
  EXPECT_EQ(time_of(90ms, 40ms), 40ms);
  EXPECT_EQ(time_of(90ms, std::nullopt), 90ms);
  EXPECT_EQ(time_of(std::nullopt, std::nullopt), 70ms);
  source.now = {};
  EXPECT_EQ(time_of(std::nullopt, std::nullopt), 250ms);
}

TEST(SourcePlayback, TheNextBeginsWhereTheLastEnded) {
  ManualClock clock;
  ScriptedSource source;
  source.keyframes = {marked(1, 100ms), marked(2, 100ms)};
  SourcePlayback playback(borrow(source), {});
  EXPECT_EQ(begun(playback, clock.now()), Marks{1});
  clock.advance(130ms);
  EXPECT_EQ(begun(playback, clock.now()), Marks{2});
  EXPECT_EQ(playback.progress().position, 15);
  EXPECT_EQ(playback.keyframes_played(), 1U);
}

TEST(SourcePlayback, ShortKeyframesMayBeginAndEndInOneTick) {
  ManualClock clock;
  ScriptedSource source;
  source.keyframes = {marked(1, 1ms), marked(2, 1ms), marked(3, 1ms), marked(4, 100ms)};
  SourcePlayback playback(borrow(source), {});
  EXPECT_EQ(begun(playback, clock.now()), Marks{1});
  clock.advance(5ms);
  EXPECT_EQ(begun(playback, clock.now()), (Marks{2, 3, 4}));
  EXPECT_EQ(playback.keyframes_played(), 3U);
  EXPECT_EQ(playback.progress().mu, 0.02);
  EXPECT_EQ(playback.media_time(), 3ms);
}

TEST(SourcePlayback, AKeyframeOfNoTimeIsAJump) {
  ManualClock clock;
  ScriptedSource source;
  source.keyframes = {marked(1, 0ms), marked(2, 0ms), marked(3, 10ms), marked(4, 0ms)};
  source.now.end = EndReason::EndOfStream;
  SourcePlayback playback(borrow(source), {});
  auto first = playback.advance(clock.now());
  ASSERT_TRUE(first);
  EXPECT_EQ(playback.progress().position, 50);
  EXPECT_EQ(playback.progress().mu, 1.0);
  EXPECT_EQ(begun(playback, clock.now()), (Marks{2, 3}));
  clock.advance(10ms);
  EXPECT_EQ(begun(playback, clock.now()), Marks{4});
  EXPECT_EQ(playback.state(), PlaybackState::Ended);
  EXPECT_EQ(playback.keyframes_played(), 4U);
}

TEST(SourcePlayback, CountsAStallOnceAndStartsTheClockAnew) {
  ManualClock clock;
  ScriptedSource source;
  source.keyframes = {marked(1, 100ms)};
  SourcePlayback playback(borrow(source), {});
  EXPECT_EQ(begun(playback, clock.now()), Marks{1});
  clock.advance(120ms);
  for (int tick = 0; tick < 5; ++tick) {
    EXPECT_EQ(begun(playback, clock.now()), Marks{});
    EXPECT_EQ(playback.state(), PlaybackState::Stalled);
    EXPECT_EQ(playback.progress().position, 50) << "the face holds";
    EXPECT_FALSE(playback.next_position_at());
    clock.advance(10ms);
  }
  EXPECT_EQ(playback.stalls(), 1U);
  EXPECT_EQ(playback.keyframes_played(), 1U);

  source.keyframes = {marked(2, 100ms)};
  EXPECT_EQ(begun(playback, clock.now()), Marks{2});
  EXPECT_EQ(playback.progress().position, 0) << "after a stall it takes its whole time";
  EXPECT_EQ(playback.next_position_at(), clock.now() + 2ms);
  clock.advance(100ms);
  source.now.end = EndReason::EndOfStream;
  EXPECT_EQ(begun(playback, clock.now()), Marks{});
  EXPECT_EQ(playback.state(), PlaybackState::Ended);
  EXPECT_EQ(playback.stalls(), 1U);
  EXPECT_EQ(playback.media_time(), 200ms);
}

TEST(SourcePlayback, ALateTickIsNoStallWhenTheNextIsThere) {
  ManualClock clock;
  ScriptedSource source;
  source.keyframes = {marked(1, 100ms)};
  SourcePlayback playback(borrow(source), {});
  EXPECT_EQ(begun(playback, clock.now()), Marks{1});
  clock.advance(140ms);
  source.keyframes = {marked(2, 100ms)};
  EXPECT_EQ(begun(playback, clock.now()), Marks{2});
  EXPECT_EQ(playback.stalls(), 0U);
  EXPECT_EQ(playback.progress().position, 20);
}

TEST(SourcePlayback, NamesEveryEnd) {
  const auto state_at_end = [](EndReason reason) {
    ManualClock clock;
    ScriptedSource source;
    source.keyframes = {marked(1, 10ms)};
    source.now.end = reason;
    SourcePlayback playback(borrow(source), {});
    EXPECT_EQ(begun(playback, clock.now()), Marks{1});
    clock.advance(9ms);
    EXPECT_EQ(begun(playback, clock.now()), Marks{});
    EXPECT_EQ(playback.state(), PlaybackState::Playing) << "what was received is played out";
    clock.advance(1s);
    EXPECT_EQ(begun(playback, clock.now()), Marks{});
    EXPECT_EQ(playback.media_time(), 10ms) << "the boundary, not the tick";
    EXPECT_FALSE(playback.next_position_at());
    EXPECT_EQ(playback.stalls(), 0U);
    return playback.state();
  };
  EXPECT_EQ(state_at_end(EndReason::EndOfStream), PlaybackState::Ended);
  EXPECT_EQ(state_at_end(EndReason::Stopped), PlaybackState::Stopped);
  EXPECT_EQ(state_at_end(EndReason::ConnectionLost), PlaybackState::Lost);
  EXPECT_EQ(state_at_end(EndReason::ProtocolError), PlaybackState::Lost);
  EXPECT_EQ(state_at_end(EndReason::Unreachable), PlaybackState::Lost);
  EXPECT_EQ(state_at_end(EndReason::Refused), PlaybackState::Lost);
}

TEST(SourcePlayback, AnEmptyStreamEndsWithoutPlaying) {
  ManualClock clock;
  ScriptedSource source;
  source.now.end = EndReason::EndOfStream;
  SourcePlayback playback(borrow(source), {});
  EXPECT_EQ(begun(playback, clock.now()), Marks{});
  EXPECT_EQ(playback.state(), PlaybackState::Ended);
  EXPECT_EQ(playback.keyframes_played(), 0U);
}

/// Looks empty at the first take; the keyframe comes just before ready() is asked.
class LastMomentSource final : public KeyframeSource {
 public:
  [[nodiscard]] std::optional<Keyframe> take() override {
    return ++asked_ == 2 ? std::optional(marked(7)) : std::nullopt;
  }
  [[nodiscard]] bool ready() const override { return true; }
  bool wait_until(Instant /*until*/) override { return true; }
  [[nodiscard]] SourceStatus status() const override {
    SourceStatus status;
    status.end = EndReason::EndOfStream;
    return status;
  }
  void stop() override {}

 private:
  int asked_ = 0;
};

TEST(SourcePlayback, MissesNoKeyframeThatComesTogetherWithTheEnd) {
  ManualClock clock;
  LastMomentSource source;
  SourcePlayback playback(borrow(source), {});
  const auto keyframe = playback.advance(clock.now());
  ASSERT_TRUE(keyframe);
  EXPECT_EQ(mark_of(keyframe->target), 7);
}

TEST(SourcePlayback, PauseKeepsTheFraction) {
  ManualClock clock;
  ScriptedSource source;
  source.keyframes = {marked(1, 100ms), marked(2, 100ms)};
  source.now.end = EndReason::EndOfStream;
  SourcePlayback playback(borrow(source), {});
  EXPECT_EQ(begun(playback, clock.now()), Marks{1});
  clock.advance(37ms);
  playback.pause(clock.now());
  EXPECT_EQ(playback.state(), PlaybackState::Paused);
  EXPECT_EQ(playback.progress().position, 18);
  EXPECT_EQ(playback.progress().mu, 0.37);
  EXPECT_FALSE(playback.next_position_at());
  clock.advance(10s);
  playback.pause(clock.now());
  EXPECT_EQ(begun(playback, clock.now()), Marks{});
  EXPECT_EQ(playback.progress().mu, 0.37);
  playback.resume(clock.now());
  EXPECT_EQ(playback.state(), PlaybackState::Playing);
  EXPECT_EQ(begun(playback, clock.now()), Marks{});
  EXPECT_EQ(playback.progress().mu, 0.37);
  clock.advance(63ms);
  EXPECT_EQ(begun(playback, clock.now()), Marks{2});
  EXPECT_EQ(playback.next_position_at(), clock.now() + 2ms) << "the pause took nothing away";
  clock.advance(100ms);
  EXPECT_EQ(begun(playback, clock.now()), Marks{});
  EXPECT_EQ(playback.state(), PlaybackState::Ended);
  EXPECT_EQ(playback.media_time(), 200ms);
  EXPECT_EQ(playback.stalls(), 0U);
}

TEST(SourcePlayback, PauseWhileBufferingOrStalledComesBackThere) {
  ManualClock clock;
  ScriptedSource source;
  SourcePlayback playback(borrow(source), {});
  playback.pause(clock.now());
  source.keyframes = {marked(1, 10ms)};
  EXPECT_EQ(begun(playback, clock.now()), Marks{}) << "paused: nothing begins";
  playback.resume(clock.now());
  EXPECT_EQ(playback.state(), PlaybackState::Buffering);
  EXPECT_EQ(begun(playback, clock.now()), Marks{1});
  clock.advance(10ms);
  EXPECT_EQ(begun(playback, clock.now()), Marks{});
  ASSERT_EQ(playback.state(), PlaybackState::Stalled);
  playback.pause(clock.now());
  clock.advance(1s);
  playback.resume(clock.now());
  EXPECT_EQ(playback.state(), PlaybackState::Stalled);
  EXPECT_EQ(playback.stalls(), 1U);
}

TEST(SourcePlayback, ResumeWithoutPauseDoesNothing) {
  ManualClock clock;
  ScriptedSource source;
  source.keyframes = {marked(1, 100ms)};
  SourcePlayback playback(borrow(source), {});
  EXPECT_EQ(begun(playback, clock.now()), Marks{1});
  clock.advance(50ms);
  playback.resume(clock.now());
  EXPECT_EQ(begun(playback, clock.now()), Marks{});
  EXPECT_EQ(playback.progress().position, 25);
}

TEST(SourcePlayback, StopHoldsTheLastPositionReached) {
  ManualClock clock;
  ScriptedSource source;
  source.keyframes = {marked(1, 100ms), marked(2, 100ms)};
  SourcePlayback playback(borrow(source), {});
  EXPECT_EQ(begun(playback, clock.now()), Marks{1});
  clock.advance(51ms);
  playback.stop(clock.now());
  EXPECT_EQ(playback.state(), PlaybackState::Stopped);
  EXPECT_EQ(playback.progress().position, 25);
  EXPECT_EQ(playback.keyframes_played(), 0U);
  clock.advance(1s);
  EXPECT_EQ(begun(playback, clock.now()), Marks{});
  playback.pause(clock.now());
  playback.resume(clock.now());
  playback.stop(clock.now());
  EXPECT_EQ(playback.state(), PlaybackState::Stopped);
}

TEST(SourcePlayback, StopCountsTheKeyframeThatIsWhole) {
  for (const bool paused : {false, true}) {
    ManualClock clock;
    ScriptedSource source;
    source.keyframes = {marked(1, 100ms)};
    SourcePlayback playback(borrow(source), {});
    EXPECT_EQ(begun(playback, clock.now()), Marks{1});
    clock.advance(150ms);
    if (paused) playback.pause(clock.now());
    playback.stop(clock.now());
    EXPECT_EQ(playback.keyframes_played(), 1U);
    EXPECT_EQ(playback.media_time(), 100ms);
  }
}

TEST(PlaybackState, HasNames) {
  EXPECT_EQ(name(PlaybackState::Buffering), "buffering");
  EXPECT_EQ(name(PlaybackState::Playing), "playing");
  EXPECT_EQ(name(PlaybackState::Stalled), "stalled");
  EXPECT_EQ(name(PlaybackState::Paused), "paused");
  EXPECT_EQ(name(PlaybackState::Ended), "ended");
  EXPECT_EQ(name(PlaybackState::Stopped), "stopped");
  EXPECT_EQ(name(PlaybackState::Lost), "lost");
}

TEST(SourcePlaybackDeathTest, WantsNoNegativeTime) {
  ScriptedSource source;
  source.keyframes = {marked(1, -1ms)};
  SourcePlayback playback(borrow(source), {});
  EXPECT_DEATH(static_cast<void>(playback.advance(Instant{})), "broken invariant");
}

}  // namespace
}  // namespace aucast::playback
