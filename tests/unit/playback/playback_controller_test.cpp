#include "client/playback/playback_controller.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/support/manual_clock.h"
#include "tests/unit/playback/marked.h"
#include "tests/unit/playback/scripted_source.h"

namespace aucast::playback {
namespace {

using namespace std::chrono_literals;
using aucast::test::ManualClock;
using test::mark_of;
using test::marked;
using test::ScriptedSource;

/// All keyframes that begin by `now`, by their marks.
std::vector<int> begun(PlaybackController& controller, Instant now, ScriptedSource& source) {
  std::vector<int> marks;
  while (const auto keyframe = controller.advance(now, source)) {
    marks.push_back(mark_of(keyframe->target));
  }
  return marks;
}

using Marks = std::vector<int>;

TEST(PlaybackController, WaitsForTheFirstKeyframe) {
  ManualClock clock;
  ScriptedSource source;
  PlaybackController controller(std::nullopt);
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{});
  EXPECT_EQ(controller.state(), PlaybackState::Buffering);
  EXPECT_EQ(controller.progress().keyframe, 0U);
  EXPECT_FALSE(controller.next_position_at());

  clock.advance(3s);
  source.keyframes = {marked(1)};
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{1});
  EXPECT_EQ(controller.state(), PlaybackState::Playing);
  EXPECT_EQ(controller.progress().keyframe, 1U);
  EXPECT_EQ(controller.progress().position, 0);
  EXPECT_EQ(controller.stalls(), 0U) << "waiting for the first is no stall";
}

TEST(PlaybackController, ReachesFiftyPositionsByTheClock) {
  ManualClock clock;
  ScriptedSource source;
  source.keyframes = {marked(1, 250ms)};
  PlaybackController controller(std::nullopt);
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{1});
  for (int k = 0; k < kPositionsPerKeyframe; ++k) {
    EXPECT_EQ(controller.progress().position, k);
    EXPECT_EQ(controller.progress().mu, k / 50.0);
    ASSERT_EQ(controller.next_position_at(), clock.now() + 5ms);
    clock.advance(5ms - 1ns);
    EXPECT_EQ(begun(controller, clock.now(), source), Marks{});
    EXPECT_EQ(controller.progress().position, k) << "a nanosecond before";
    clock.advance(1ns);
    EXPECT_EQ(begun(controller, clock.now(), source), Marks{});
  }
  EXPECT_EQ(controller.progress().position, 50);
  EXPECT_EQ(controller.progress().mu, 1.0);
}

TEST(PlaybackController, TakesAKeyframesTimeFromPacketSpeedServerInThisOrder) {
  ManualClock clock;
  ScriptedSource source;
  source.now.keyframe_time = 70ms;
  const auto time_of = [&](std::optional<Milliseconds> speed, std::optional<Milliseconds> own) {
    source.keyframes = {marked(1, own)};
    PlaybackController controller(speed);
    const auto keyframe = controller.advance(clock.now(), source);
    return keyframe ? keyframe->time : -1ms;
  };
  EXPECT_EQ(time_of(90ms, 40ms), 40ms);
  EXPECT_EQ(time_of(90ms, std::nullopt), 90ms);
  EXPECT_EQ(time_of(std::nullopt, std::nullopt), 70ms);
  source.now = {};
  EXPECT_EQ(time_of(std::nullopt, std::nullopt), 250ms);
}

TEST(PlaybackController, TheNextBeginsWhereTheLastEnded) {
  ManualClock clock;
  ScriptedSource source;
  source.keyframes = {marked(1, 100ms), marked(2, 100ms)};
  PlaybackController controller(std::nullopt);
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{1});
  clock.advance(130ms);
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{2});
  EXPECT_EQ(controller.progress().position, 15);
  EXPECT_EQ(controller.keyframes_played(), 1U);
}

TEST(PlaybackController, ShortKeyframesMayBeginAndEndInOneTick) {
  ManualClock clock;
  ScriptedSource source;
  source.keyframes = {marked(1, 1ms), marked(2, 1ms), marked(3, 1ms), marked(4, 100ms)};
  PlaybackController controller(std::nullopt);
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{1});
  clock.advance(5ms);
  EXPECT_EQ(begun(controller, clock.now(), source), (Marks{2, 3, 4}));
  EXPECT_EQ(controller.keyframes_played(), 3U);
  EXPECT_EQ(controller.progress().mu, 0.02);
  EXPECT_EQ(controller.media_time(), 3ms);
}

TEST(PlaybackController, AKeyframeOfNoTimeIsAJump) {
  ManualClock clock;
  ScriptedSource source;
  source.keyframes = {marked(1, 0ms), marked(2, 0ms), marked(3, 10ms), marked(4, 0ms)};
  source.now.end = EndReason::EndOfStream;
  PlaybackController controller(std::nullopt);
  auto first = controller.advance(clock.now(), source);
  ASSERT_TRUE(first);
  EXPECT_EQ(controller.progress().position, 50);
  EXPECT_EQ(controller.progress().mu, 1.0);
  EXPECT_EQ(begun(controller, clock.now(), source), (Marks{2, 3}));
  clock.advance(10ms);
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{4});
  EXPECT_EQ(controller.state(), PlaybackState::Ended);
  EXPECT_EQ(controller.keyframes_played(), 4U);
}

TEST(PlaybackController, CountsAStallOnceAndStartsTheClockAnew) {
  ManualClock clock;
  ScriptedSource source;
  source.keyframes = {marked(1, 100ms)};
  PlaybackController controller(std::nullopt);
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{1});
  clock.advance(120ms);
  for (int tick = 0; tick < 5; ++tick) {
    EXPECT_EQ(begun(controller, clock.now(), source), Marks{});
    EXPECT_EQ(controller.state(), PlaybackState::Stalled);
    EXPECT_EQ(controller.progress().position, 50) << "the face holds";
    EXPECT_FALSE(controller.next_position_at());
    clock.advance(10ms);
  }
  EXPECT_EQ(controller.stalls(), 1U);
  EXPECT_EQ(controller.keyframes_played(), 1U);

  source.keyframes = {marked(2, 100ms)};
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{2});
  EXPECT_EQ(controller.progress().position, 0) << "after a stall it takes its whole time";
  EXPECT_EQ(controller.next_position_at(), clock.now() + 2ms);
  clock.advance(100ms);
  source.now.end = EndReason::EndOfStream;
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{});
  EXPECT_EQ(controller.state(), PlaybackState::Ended);
  EXPECT_EQ(controller.stalls(), 1U);
  EXPECT_EQ(controller.media_time(), 200ms);
}

TEST(PlaybackController, ALateTickIsNoStallWhenTheNextIsThere) {
  ManualClock clock;
  ScriptedSource source;
  source.keyframes = {marked(1, 100ms)};
  PlaybackController controller(std::nullopt);
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{1});
  clock.advance(140ms);
  source.keyframes = {marked(2, 100ms)};
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{2});
  EXPECT_EQ(controller.stalls(), 0U);
  EXPECT_EQ(controller.progress().position, 20);
}

TEST(PlaybackController, NamesEveryEnd) {
  const auto state_at_end = [](EndReason reason) {
    ManualClock clock;
    ScriptedSource source;
    source.keyframes = {marked(1, 10ms)};
    source.now.end = reason;
    PlaybackController controller(std::nullopt);
    EXPECT_EQ(begun(controller, clock.now(), source), Marks{1});
    clock.advance(9ms);
    EXPECT_EQ(begun(controller, clock.now(), source), Marks{});
    EXPECT_EQ(controller.state(), PlaybackState::Playing) << "what was received is played out";
    clock.advance(1s);
    EXPECT_EQ(begun(controller, clock.now(), source), Marks{});
    EXPECT_EQ(controller.media_time(), 10ms) << "the boundary, not the tick";
    EXPECT_FALSE(controller.next_position_at());
    EXPECT_EQ(controller.stalls(), 0U);
    return controller.state();
  };
  EXPECT_EQ(state_at_end(EndReason::EndOfStream), PlaybackState::Ended);
  EXPECT_EQ(state_at_end(EndReason::Stopped), PlaybackState::Stopped);
  EXPECT_EQ(state_at_end(EndReason::ConnectionLost), PlaybackState::Lost);
  EXPECT_EQ(state_at_end(EndReason::ProtocolError), PlaybackState::Lost);
  EXPECT_EQ(state_at_end(EndReason::Unreachable), PlaybackState::Lost);
  EXPECT_EQ(state_at_end(EndReason::Refused), PlaybackState::Lost);
}

TEST(PlaybackController, AnEmptyStreamEndsWithoutPlaying) {
  ManualClock clock;
  ScriptedSource source;
  source.now.end = EndReason::EndOfStream;
  PlaybackController controller(std::nullopt);
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{});
  EXPECT_EQ(controller.state(), PlaybackState::Ended);
  EXPECT_EQ(controller.keyframes_played(), 0U);
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

TEST(PlaybackController, MissesNoKeyframeThatComesTogetherWithTheEnd) {
  ManualClock clock;
  LastMomentSource source;
  PlaybackController controller(std::nullopt);
  const auto keyframe = controller.advance(clock.now(), source);
  ASSERT_TRUE(keyframe);
  EXPECT_EQ(mark_of(keyframe->target), 7);
}

TEST(PlaybackController, PauseKeepsTheFraction) {
  ManualClock clock;
  ScriptedSource source;
  source.keyframes = {marked(1, 100ms), marked(2, 100ms)};
  source.now.end = EndReason::EndOfStream;
  PlaybackController controller(std::nullopt);
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{1});
  clock.advance(37ms);
  controller.pause(clock.now());
  EXPECT_EQ(controller.state(), PlaybackState::Paused);
  EXPECT_EQ(controller.progress().position, 18);
  EXPECT_EQ(controller.progress().mu, 0.37);
  EXPECT_FALSE(controller.next_position_at());
  clock.advance(10s);
  controller.pause(clock.now());
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{});
  EXPECT_EQ(controller.progress().mu, 0.37);
  controller.resume(clock.now());
  EXPECT_EQ(controller.state(), PlaybackState::Playing);
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{});
  EXPECT_EQ(controller.progress().mu, 0.37);
  clock.advance(63ms);
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{2});
  EXPECT_EQ(controller.next_position_at(), clock.now() + 2ms) << "the pause took nothing away";
  clock.advance(100ms);
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{});
  EXPECT_EQ(controller.state(), PlaybackState::Ended);
  EXPECT_EQ(controller.media_time(), 200ms);
  EXPECT_EQ(controller.stalls(), 0U);
}

TEST(PlaybackController, PauseWhileBufferingOrStalledComesBackThere) {
  ManualClock clock;
  ScriptedSource source;
  PlaybackController controller(std::nullopt);
  controller.pause(clock.now());
  source.keyframes = {marked(1, 10ms)};
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{}) << "paused: nothing begins";
  controller.resume(clock.now());
  EXPECT_EQ(controller.state(), PlaybackState::Buffering);
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{1});
  clock.advance(10ms);
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{});
  ASSERT_EQ(controller.state(), PlaybackState::Stalled);
  controller.pause(clock.now());
  clock.advance(1s);
  controller.resume(clock.now());
  EXPECT_EQ(controller.state(), PlaybackState::Stalled);
  EXPECT_EQ(controller.stalls(), 1U);
}

TEST(PlaybackController, ResumeWithoutPauseDoesNothing) {
  ManualClock clock;
  ScriptedSource source;
  source.keyframes = {marked(1, 100ms)};
  PlaybackController controller(std::nullopt);
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{1});
  clock.advance(50ms);
  controller.resume(clock.now());
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{});
  EXPECT_EQ(controller.progress().position, 25);
}

TEST(PlaybackController, StopHoldsTheLastPositionReached) {
  ManualClock clock;
  ScriptedSource source;
  source.keyframes = {marked(1, 100ms), marked(2, 100ms)};
  PlaybackController controller(std::nullopt);
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{1});
  clock.advance(51ms);
  controller.stop(clock.now());
  EXPECT_EQ(controller.state(), PlaybackState::Stopped);
  EXPECT_EQ(controller.progress().position, 25);
  EXPECT_EQ(controller.keyframes_played(), 0U);
  clock.advance(1s);
  EXPECT_EQ(begun(controller, clock.now(), source), Marks{});
  controller.pause(clock.now());
  controller.resume(clock.now());
  controller.stop(clock.now());
  EXPECT_EQ(controller.state(), PlaybackState::Stopped);
}

TEST(PlaybackController, StopCountsTheKeyframeThatIsWhole) {
  for (const bool paused : {false, true}) {
    ManualClock clock;
    ScriptedSource source;
    source.keyframes = {marked(1, 100ms)};
    PlaybackController controller(std::nullopt);
    EXPECT_EQ(begun(controller, clock.now(), source), Marks{1});
    clock.advance(150ms);
    if (paused) controller.pause(clock.now());
    controller.stop(clock.now());
    EXPECT_EQ(controller.keyframes_played(), 1U);
    EXPECT_EQ(controller.media_time(), 100ms);
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

TEST(PlaybackControllerDeathTest, WantsNoNegativeTime) {
  ScriptedSource source;
  source.keyframes = {marked(1, -1ms)};
  PlaybackController controller(std::nullopt);
  EXPECT_DEATH(static_cast<void>(controller.advance(Instant{}, source)), "broken invariant");
}

}  // namespace
}  // namespace aucast::playback
