// What an hour of playing adds up to, on a manual clock with ticks as uneven as real ones.

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "client/playback/file_source.h"
#include "client/playback/source_playback.h"
#include "tests/support/manual_clock.h"
#include "tests/support/seeded.h"
#include "tests/unit/playback/marked.h"
#include "tests/unit/playback/scripted_source.h"

namespace aucast::playback {
namespace {

using namespace std::chrono_literals;
using aucast::test::ManualClock;
using aucast::test::Seeded;
using test::borrow;
using test::mark_of;
using test::marked;
using test::ScriptedSource;

/// When the face reaches the keyframe under way, which takes `time`: exact, not only to a tick.
Instant end_of(const SourcePlayback& playback, Milliseconds time) {
  const int next = std::min(playback.progress().position + 1, kPositionsPerKeyframe);
  const Duration left = Duration(time) - Duration(time) * next / kPositionsPerKeyframe;
  return playback.next_position_at().value() + left;
}

TEST(PlaybackTiming, AnHourOfKeyframesTakesAnHour) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  constexpr int kCount = 14'400;
  FileSource source(std::vector<Keyframe>(kCount, marked(1)));
  SourcePlayback playback(borrow(source), {.speed = 250ms});
  ManualClock clock;
  const Instant begin = clock.now();
  Instant end = begin;
  while (playback.state() != PlaybackState::Ended) {
    while (playback.advance(clock.now())) end = end_of(playback, 250ms);
    const Duration tick = seeded.chance(0.001) ? Duration(400ms) : Duration(16'667us);
    clock.advance(tick + std::chrono::microseconds(seeded.integer(-9'000, 9'000)));
  }
  EXPECT_EQ(playback.keyframes_played(), 14'400U);
  EXPECT_EQ(playback.media_time(), 1h);
  EXPECT_EQ(end - begin, 1h) << "exact, not only to within a frame";
  EXPECT_LE(clock.now() - begin, 1h + 900ms) << "the end was noticed at the next tick";
  EXPECT_EQ(playback.stalls(), 0U);
}

TEST(PlaybackTiming, FollowingNextPositionMeetsEveryPositionOnce) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  std::vector<Keyframe> keyframes;
  Milliseconds total{0};
  for (int i = 0; i < 200; ++i) {
    const Milliseconds duration(seeded.integer(1, 1000));
    keyframes.push_back(marked(i + 1, duration));
    total += duration;
  }
  FileSource source(keyframes);
  SourcePlayback playback(borrow(source), {});
  ManualClock clock;
  const Instant begin = clock.now();
  int positions = 0;
  while (playback.advance(clock.now())) {
  }
  while (const auto next = playback.next_position_at()) {
    ASSERT_GT(*next, clock.now());
    clock.advance(*next - clock.now());
    const PlaybackProgress before = playback.progress();
    int begun = 0;
    while (playback.advance(clock.now())) ++begun;
    const PlaybackProgress now = playback.progress();
    ++positions;
    if (before.position == 49 && playback.state() == PlaybackState::Playing) {
      ASSERT_EQ(begun, 1);
      ASSERT_EQ(now.keyframe, before.keyframe + 1);
      ASSERT_EQ(now.position, 0);
    } else {
      ASSERT_EQ(now.position, before.position + 1);
      ASSERT_EQ(now.mu, now.position / 50.0);
    }
  }
  EXPECT_EQ(positions, 200 * kPositionsPerKeyframe);
  EXPECT_EQ(clock.now() - begin, total);
}

// The model: every keyframe begins at the end of the one before, or at the first tick after it had
// come when it came late.
TEST(PlaybackTiming, AgreesWithItsModelWhateverTheSourceDoes) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int round = 0; round < 100; ++round) {
    ScriptedSource source;
    SourcePlayback playback(borrow(source), {});
    ManualClock clock;
    const int count = seeded.integer(1, 60);
    int arrived = 0;
    int begun = 0;
    std::uint64_t stalls = 0;
    bool stalled = false;
    Instant current_end = clock.now();
    Milliseconds media{0};
    while (playback.state() != PlaybackState::Ended) {
      while (arrived < count && seeded.chance(0.4)) {
        source.keyframes.push_back(marked(++arrived, Milliseconds(seeded.integer(0, 80))));
      }
      if (arrived == count) source.now.end = EndReason::EndOfStream;
      while (const auto keyframe = playback.advance(clock.now())) {
        ASSERT_EQ(mark_of(keyframe->target), ++begun);
        const bool anew = begun == 1 || stalled;
        const Instant begin = anew ? clock.now() : current_end;
        current_end = begin + keyframe->time;
        ASSERT_EQ(end_of(playback, keyframe->time), current_end);
        media += keyframe->time;
        stalled = false;
      }
      if (playback.state() == PlaybackState::Stalled && !stalled) {
        stalled = true;
        ++stalls;
      }
      clock.advance(std::chrono::milliseconds(seeded.integer(0, 50)));
    }
    EXPECT_EQ(begun, count);
    EXPECT_EQ(playback.keyframes_played(), static_cast<std::uint64_t>(count));
    EXPECT_EQ(playback.stalls(), stalls);
    EXPECT_EQ(playback.media_time(), media);
  }
}

}  // namespace
}  // namespace aucast::playback
