// The two buffers while the stream is live.

#include <deque>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "client/playback/keyframe_buffers.h"
#include "tests/support/seeded.h"
#include "tests/unit/playback/marked.h"

namespace aucast::playback {
namespace {

using namespace std::chrono_literals;
using aucast::test::Seeded;
using test::mark_of;
using test::marked;

/// Keyframe `mark` of a live stream, untimed unless `time` is given.
Keyframe keyframe_of(int mark, std::optional<Milliseconds> time = std::nullopt) {
  Keyframe made = marked(mark);
  made.time = time;
  return made;
}

class LiveBuffers : public ::testing::Test {
 protected:
  LiveBuffers() { buffers_.set_live(true); }

  /// Begins anew, with a live stream whose keyframes take `untimed`.
  void begin(const BufferOptions& options, Milliseconds untimed) {
    buffers_ = KeyframeBuffers(options);
    buffers_.set_live(true);
    buffers_.set_untimed(untimed);
  }
  void store(int mark, std::optional<Milliseconds> time = std::nullopt) {
    EXPECT_EQ(buffers_.store(keyframe_of(mark, time)), KeyframeBuffers::Stored::Yes);
  }
  /// The mark of the next keyframe, 0 when there is none.
  int take() {
    const auto taken = buffers_.take();
    pace_ = taken ? taken->pace_percent : 0;
    return taken ? mark_of(*taken) : 0;
  }

  KeyframeBuffers buffers_{BufferOptions{}};
  int pace_ = 0;  ///< of the keyframe taken last
};

TEST_F(LiveBuffers, StartWithTwoKeyframesThatAreWorthTheDelay) {
  store(1);
  EXPECT_FALSE(buffers_.has_next());
  store(2);
  EXPECT_TRUE(buffers_.has_next()) << "500 ms, and not forty sets";
}

TEST_F(LiveBuffers, StartLaterWhereKeyframesAreShort) {
  for (int mark = 1; mark <= 9; ++mark) store(mark, 33ms);
  EXPECT_FALSE(buffers_.has_next()) << "297 ms";
  store(10, 33ms);
  EXPECT_TRUE(buffers_.has_next());
}

TEST_F(LiveBuffers, StartWithTwoWhereKeyframesAreLong) {
  store(1, 2s);
  EXPECT_FALSE(buffers_.has_next());
  store(2, 2s);
  EXPECT_TRUE(buffers_.has_next());
}

TEST_F(LiveBuffers, GoOnWithOneThatComesInTime) {
  store(1);
  store(2);
  EXPECT_EQ(take(), 1);
  EXPECT_EQ(take(), 2);
  store(3);
  EXPECT_EQ(take(), 3) << "the player had not yet asked for it";
}

TEST_F(LiveBuffers, BuildUpTheDelayAgainAfterAStall) {
  store(1);
  store(2);
  take();
  take();
  EXPECT_EQ(take(), 0);
  store(3);
  EXPECT_EQ(take(), 0);
  store(4);
  EXPECT_EQ(take(), 3);
}

TEST_F(LiveBuffers, PlayWhatIsThereAtTheEnd) {
  store(1);
  EXPECT_EQ(take(), 0);
  buffers_.end_of_stream();
  EXPECT_EQ(take(), 1);
  EXPECT_TRUE(buffers_.finished());
}

TEST_F(LiveBuffers, LeaveTheTimesAloneInSteadyPlay) {
  store(1);
  store(2);
  for (int mark = 3; mark < 50; ++mark) {
    EXPECT_EQ(take(), mark - 2);
    EXPECT_EQ(pace_, 100) << mark;
    store(mark);
  }
  EXPECT_EQ(buffers_.dropped(), 0U);
}

TEST_F(LiveBuffers, PlayFasterToCatchUp) {
  for (int mark = 1; mark <= 5; ++mark) store(mark);
  EXPECT_EQ(take(), 1);
  EXPECT_EQ(pace_, 95) << "1000 ms are left";
  store(6, 100ms);
  take();
  take();
  EXPECT_EQ(take(), 4);
  EXPECT_EQ(pace_, 100) << "350 ms are left, which is no more than a keyframe ahead";
}

TEST_F(LiveBuffers, DropTheOldestWhenFarBehind) {
  for (int mark = 1; mark <= 9; ++mark) store(mark);  // 2250 ms
  EXPECT_EQ(buffers_.dropped(), 0U);
  store(10);
  EXPECT_EQ(buffers_.dropped(), 8U);
  EXPECT_EQ(take(), 9);
  EXPECT_EQ(take(), 10);
}

TEST_F(LiveBuffers, KeepTwoHoweverLongTheyAre) {
  for (int mark = 1; mark <= 4; ++mark) store(mark, 1h);
  EXPECT_EQ(buffers_.dropped(), 2U);
  EXPECT_EQ(take(), 3);
  EXPECT_EQ(take(), 4);
}

TEST_F(LiveBuffers, LeaveNothingOutWhilePlaying) {
  store(1);
  store(2);
  EXPECT_EQ(take(), 1);
  for (int mark = 3; mark <= 60; ++mark) store(mark);  // a link that was down is up again
  for (int mark = 2; mark <= 60; ++mark) EXPECT_EQ(take(), mark);
  EXPECT_EQ(buffers_.dropped(), 0U);
}

TEST_F(LiveBuffers, PlaySlowerToBuildUpTheDelayThatTheLinkNeeds) {
  BufferOptions options;
  options.adapt = true;
  begin(options, 100ms);
  for (int mark = 1; mark <= 5; ++mark) store(mark);
  EXPECT_EQ(take(), 1);
  EXPECT_EQ(pace_, 100);
  buffers_.set_delay(1000ms);
  for (int mark = 6; mark <= 200; ++mark) {
    store(mark);
    EXPECT_EQ(take(), mark - 4);
    EXPECT_EQ(pace_, 105) << "and no more than that";
  }
}

/// However the target moves, a keyframe's time never changes by more than a twentieth.
TEST_F(LiveBuffers, NeverPlayFasterThanFivePercent) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  BufferOptions options;
  options.adapt = true;
  begin(options, 33ms);
  int stored = 0;
  for (int i = 0; i < 3000; ++i) {
    const Milliseconds time(seeded.integer(1, 500));
    if (seeded.chance(0.5)) store(++stored, time);
    buffers_.set_delay(Milliseconds(seeded.integer(0, 3000)));
    const auto before = buffers_.buffered();
    const auto taken = buffers_.take();
    if (!taken) continue;
    EXPECT_EQ(taken->time, before - buffers_.buffered()) << "its own time is left alone";
    EXPECT_GE(taken->pace_percent, 95);
    EXPECT_LE(taken->pace_percent, 105);
  }
}

TEST_F(LiveBuffers, TellHowMuchTheyHoldWhateverHappens) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  BufferOptions options;
  options.receiver_capacity = 50;
  buffers_ = KeyframeBuffers(options);
  std::deque<std::optional<Milliseconds>> held;
  int stored = 0;
  for (int i = 0; i < 3000; ++i) {
    Milliseconds untimed(seeded.integer(1, 500));
    buffers_.set_live(true);
    if (seeded.chance(0.1)) {  // for a moment it is a recorded one
      untimed = Milliseconds(seeded.integer(1, 500));
      buffers_.set_live(false);
    } else if (seeded.chance(0.55)) {
      held.push_back(std::nullopt);
      if (seeded.chance(0.7)) held.back() = Milliseconds(seeded.integer(0, 500));
      store(++stored, held.back());
    }
    buffers_.set_untimed(untimed);
    if (seeded.chance(0.4) && buffers_.take()) held.pop_front();
    while (held.size() > buffers_.receiver_fill() + buffers_.playout_fill()) held.pop_front();
    Milliseconds sum{0};
    for (const auto& time : held) sum += time.value_or(untimed);
    ASSERT_EQ(buffers_.buffered(), sum) << i;
  }
  EXPECT_GT(buffers_.dropped(), 0U);
}

TEST(TimedBuffers, BeginByTimeAndWaitLongerAfterEachStall) {
  BufferOptions options;
  options.by_time = true;
  options.adapt = true;
  KeyframeBuffers buffers(options);
  buffers.set_untimed(100ms);
  int stored = 0;
  const auto count_to_begin = [&] {
    int count = 0;
    while (!buffers.has_next()) {
      EXPECT_EQ(buffers.store(keyframe_of(++stored)), KeyframeBuffers::Stored::Yes);
      ++count;
    }
    while (buffers.take()) {
    }
    return count;
  };
  EXPECT_EQ(count_to_begin(), 3) << "300 ms";
  EXPECT_EQ(count_to_begin(), 6);
  EXPECT_EQ(count_to_begin(), 12);
  for (int i = 0; i < 10; ++i) count_to_begin();
  EXPECT_EQ(count_to_begin(), 100) << "ten seconds at most";
}

TEST(TimedBuffers, NoStallShortensADelayOfMoreThanTenSeconds) {
  BufferOptions options{2000, 30};
  options.by_time = true;
  options.adapt = true;
  options.live_delay = 20s;
  KeyframeBuffers buffers(options);
  buffers.set_untimed(100ms);
  for (int mark = 1; !buffers.has_next(); ++mark) {
    ASSERT_LE(mark, 200);
    EXPECT_EQ(buffers.store(keyframe_of(mark)), KeyframeBuffers::Stored::Yes);
  }
  while (buffers.take()) {
  }
  EXPECT_EQ(buffers.delay(), 20s);
}

TEST(TimedBuffers, BeginWhenFullOrEnded) {
  BufferOptions options{3, 1, 100};
  options.by_time = true;
  options.live_delay = 60s;
  KeyframeBuffers buffers(options);
  for (int mark = 1; mark <= 4; ++mark) {
    EXPECT_EQ(buffers.store(keyframe_of(mark)), KeyframeBuffers::Stored::Yes);
    EXPECT_EQ(buffers.has_next(), mark == 4) << mark;
  }
  KeyframeBuffers ended(options);
  EXPECT_EQ(ended.store(keyframe_of(1)), KeyframeBuffers::Stored::Yes);
  EXPECT_FALSE(ended.has_next());
  ended.end_of_stream();
  EXPECT_TRUE(ended.has_next());
}

TEST_F(LiveBuffers, NeverHoldMoreThanTheReceiver) {
  begin(BufferOptions{3, 1, 100}, 0ms);
  for (int mark = 1; mark <= 100; ++mark) store(mark);
  EXPECT_EQ(buffers_.receiver_fill(), 3U);
  EXPECT_EQ(buffers_.playout_fill(), 1U);
  EXPECT_EQ(buffers_.dropped(), 96U);
}

TEST_F(LiveBuffers, BeginWhenTheReceiverIsFullHoweverLongTheDelay) {
  begin(BufferOptions{100, 30, 40, 10s}, 33ms);
  for (int mark = 1; mark <= 99; ++mark) store(mark);
  EXPECT_FALSE(buffers_.has_next()) << "3.3 of 10 s, and there is room";
  store(100);
  EXPECT_EQ(take(), 1);
  for (int mark = 2; mark <= 100; ++mark) EXPECT_EQ(take(), mark);
  EXPECT_EQ(take(), 0);
  for (int mark = 101; mark <= 300; ++mark) store(mark);
  EXPECT_NE(take(), 0) << "after a stall too";
}

TEST(TimedBuffers, HoldTheLongestAdaptedDelayOfAPicturesRate) {
  BufferOptions options;
  options.receiver_capacity = kReceiverSetsByTime;
  options.by_time = true;
  options.adapt = true;
  KeyframeBuffers buffers(options);
  buffers.set_live(true);
  buffers.set_untimed(33ms);
  buffers.set_delay(10s);
  int stored = 0;
  while (!buffers.has_next()) {
    ASSERT_LT(stored, 1000);
    EXPECT_EQ(buffers.store(keyframe_of(++stored)), KeyframeBuffers::Stored::Yes);
  }
  EXPECT_GE(buffers.buffered(), 10s);
  EXPECT_EQ(buffers.dropped(), 0U);
}

TEST_F(LiveBuffers, DropOneForEachThatOverflows) {
  begin(BufferOptions{10, 5, 100}, 100ms);
  for (int mark = 1; mark <= 13; ++mark) store(mark);
  EXPECT_EQ(buffers_.dropped(), 0U);
  EXPECT_EQ(buffers_.playout_fill(), 3U);
  store(14);
  EXPECT_EQ(buffers_.dropped(), 1U);
  EXPECT_EQ(buffers_.playout_fill(), 3U);
  EXPECT_EQ(buffers_.receiver_fill(), 10U);
  EXPECT_EQ(take(), 2);
}

TEST_F(LiveBuffers, GoBackToTheThresholdWhenRecorded) {
  buffers_.set_live(false);
  store(1);
  store(2);
  EXPECT_FALSE(buffers_.has_next());
}

TEST(LiveBuffersProperty, GiveEachOnceInOrderOrCountItAsDropped) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 300; ++run) {
    BufferOptions options;
    options.receiver_capacity = static_cast<std::size_t>(seeded.integer(1, 120));
    options.playout_capacity =
        static_cast<std::size_t>(seeded.integer(1, static_cast<int>(options.receiver_capacity)));
    options.live_delay = Milliseconds(seeded.integer(0, 1000));
    KeyframeBuffers buffers(options);
    buffers.set_live(true);
    buffers.set_untimed(Milliseconds(seeded.integer(1, 500)));
    const double eager = seeded.real(0.2, 0.8);
    int stored = 0;
    std::uint64_t taken = 0;
    int last = 0;
    const auto take = [&] {
      const auto next = buffers.take();
      if (!next) return false;
      EXPECT_GT(mark_of(*next), last);
      last = mark_of(*next);
      ++taken;
      return true;
    };
    while (stored < 90) {
      if (seeded.chance(eager)) {
        take();
      } else {
        EXPECT_EQ(buffers.store(keyframe_of(++stored)), KeyframeBuffers::Stored::Yes);
      }
      EXPECT_LE(buffers.receiver_fill(), options.receiver_capacity);
      EXPECT_LE(buffers.playout_fill(), options.playout_capacity);
    }
    buffers.end_of_stream();
    while (take()) {
    }
    EXPECT_TRUE(buffers.finished());
    EXPECT_EQ(last, 90) << "the newest is never dropped";
    EXPECT_EQ(taken + buffers.dropped(), 90U);
  }
}

}  // namespace
}  // namespace aucast::playback
