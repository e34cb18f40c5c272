#include "client/playback/keyframe_buffers.h"

#include <algorithm>
#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/seeded.h"
#include "tests/unit/playback/marked.h"

namespace aucast::playback {
namespace {

using aucast::test::Seeded;
using test::mark_of;
using test::marked;
using Stored = KeyframeBuffers::Stored;

/// Takes one and gives its mark, or 0 when there is none.
int take_mark(KeyframeBuffers& buffers) {
  const auto keyframe = buffers.take();
  return keyframe ? mark_of(*keyframe) : 0;
}

void store_marks(KeyframeBuffers& buffers, int first, int last) {
  for (int mark = first; mark <= last; ++mark) {
    ASSERT_EQ(buffers.store(marked(mark)), Stored::Yes) << mark;
  }
}

TEST(KeyframeBuffers, BeginsEmpty) {
  KeyframeBuffers buffers(BufferOptions{});
  EXPECT_FALSE(buffers.has_next());
  EXPECT_FALSE(buffers.take());
  EXPECT_FALSE(buffers.finished());
  EXPECT_EQ(buffers.room(), 100U);
}

// Case D: nothing is played until the receiver holds the threshold before a further one is stored.
TEST(KeyframeBuffers, CaseDFillsThePlayoutAtTheThreshold) {
  KeyframeBuffers buffers(
      {.receiver_capacity = 10, .playout_capacity = 3, .threshold_percent = 40});
  store_marks(buffers, 1, 4);
  EXPECT_FALSE(buffers.has_next());
  EXPECT_EQ(buffers.receiver_fill(), 4U);
  store_marks(buffers, 5, 5);
  EXPECT_TRUE(buffers.has_next());
  EXPECT_EQ(buffers.playout_fill(), 3U);
  EXPECT_EQ(buffers.receiver_fill(), 2U);
}

TEST(KeyframeBuffers, RoundsTheThresholdUp) {
  KeyframeBuffers buffers({.receiver_capacity = 3, .playout_capacity = 1, .threshold_percent = 34});
  store_marks(buffers, 1, 2);
  EXPECT_FALSE(buffers.has_next());
  store_marks(buffers, 3, 3);
  EXPECT_TRUE(buffers.has_next());
}

// Case C: while there is something to play, a keyframe goes to the receiver only.
TEST(KeyframeBuffers, CaseCStoresInTheReceiver) {
  KeyframeBuffers buffers(
      {.receiver_capacity = 10, .playout_capacity = 3, .threshold_percent = 10});
  store_marks(buffers, 1, 2);
  ASSERT_EQ(buffers.playout_fill(), 2U);
  store_marks(buffers, 3, 3);
  EXPECT_EQ(buffers.playout_fill(), 2U);
  EXPECT_EQ(buffers.receiver_fill(), 1U);
}

// Case B: a full receiver fills an empty playout whatever the threshold; with 100 % it is the only
// way to start.
TEST(KeyframeBuffers, CaseBStartsAtAThresholdOfAHundredPercent) {
  KeyframeBuffers buffers(
      {.receiver_capacity = 4, .playout_capacity = 2, .threshold_percent = 100});
  store_marks(buffers, 1, 4);
  EXPECT_FALSE(buffers.has_next());
  EXPECT_EQ(buffers.room(), 0U);
  store_marks(buffers, 5, 5);
  EXPECT_EQ(buffers.playout_fill(), 2U);
  EXPECT_EQ(buffers.receiver_fill(), 3U);
}

// Case A: both full, the caller keeps the keyframe; nothing changes by the attempt.
TEST(KeyframeBuffers, CaseARefuses) {
  KeyframeBuffers buffers({.receiver_capacity = 2, .playout_capacity = 2, .threshold_percent = 50});
  store_marks(buffers, 1, 4);
  EXPECT_EQ(buffers.store(marked(5)), Stored::No);
  EXPECT_EQ(buffers.receiver_fill(), 2U);
  EXPECT_EQ(buffers.playout_fill(), 2U);
  EXPECT_EQ(take_mark(buffers), 1);
  EXPECT_EQ(buffers.store(marked(5)), Stored::No) << "a place in the playout is no room";
  EXPECT_EQ(take_mark(buffers), 2);
  EXPECT_EQ(buffers.room(), 2U) << "the empty playout was filled from the receiver";
  EXPECT_EQ(buffers.store(marked(5)), Stored::Yes);
  for (const int mark : {3, 4, 5, 0}) EXPECT_EQ(take_mark(buffers), mark);
}

TEST(KeyframeBuffers, RefillsWithoutThresholdWhilePlaying) {
  KeyframeBuffers buffers(
      {.receiver_capacity = 10, .playout_capacity = 2, .threshold_percent = 50});
  store_marks(buffers, 1, 6);
  for (int mark = 1; mark <= 6; ++mark) EXPECT_EQ(take_mark(buffers), mark);
  EXPECT_FALSE(buffers.has_next());
}

TEST(KeyframeBuffers, AppliesTheThresholdAgainAfterAStall) {
  KeyframeBuffers buffers({.receiver_capacity = 4, .playout_capacity = 2, .threshold_percent = 50});
  store_marks(buffers, 1, 3);
  for (const int mark : {1, 2, 3, 0}) EXPECT_EQ(take_mark(buffers), mark);
  store_marks(buffers, 4, 5);
  EXPECT_FALSE(buffers.has_next());
  store_marks(buffers, 6, 6);
  EXPECT_TRUE(buffers.has_next());
}

TEST(KeyframeBuffers, TheEndFlushesWhatIsBelowTheThreshold) {
  KeyframeBuffers buffers(BufferOptions{});
  store_marks(buffers, 1, 1);
  EXPECT_FALSE(buffers.has_next());
  buffers.end_of_stream();
  EXPECT_TRUE(buffers.has_next());
  EXPECT_FALSE(buffers.finished());
  EXPECT_EQ(take_mark(buffers), 1);
  EXPECT_TRUE(buffers.finished());
}

TEST(KeyframeBuffers, AnEmptyStreamIsFinishedAtOnce) {
  KeyframeBuffers buffers(BufferOptions{});
  buffers.end_of_stream();
  EXPECT_TRUE(buffers.finished());
  EXPECT_FALSE(buffers.has_next());
}

TEST(KeyframeBuffers, TakesTheKeptKeyframeAfterTheEnd) {
  KeyframeBuffers buffers({.receiver_capacity = 1, .playout_capacity = 1, .threshold_percent = 1});
  store_marks(buffers, 1, 2);
  ASSERT_EQ(buffers.store(marked(3)), Stored::No);
  buffers.end_of_stream();
  EXPECT_EQ(take_mark(buffers), 1);
  EXPECT_EQ(take_mark(buffers), 2);
  EXPECT_EQ(buffers.store(marked(3)), Stored::Yes);
  EXPECT_TRUE(buffers.has_next()) << "no threshold after the end";
  EXPECT_EQ(take_mark(buffers), 3);
  EXPECT_TRUE(buffers.finished());
}

TEST(KeyframeBuffers, ReleaseStartsBelowTheThreshold) {
  KeyframeBuffers buffers({.receiver_capacity = 100, .playout_capacity = 30});
  store_marks(buffers, 1, 37);
  EXPECT_FALSE(buffers.has_next());
  buffers.release();
  EXPECT_EQ(buffers.playout_fill(), 30U);
  EXPECT_EQ(buffers.room(), 93U);
  buffers.release();
  EXPECT_EQ(buffers.playout_fill(), 30U) << "only a waiting playout is released";
}

TEST(KeyframeBuffers, ReleaseOfNothingKeepsTheThreshold) {
  KeyframeBuffers buffers({.receiver_capacity = 4, .playout_capacity = 2, .threshold_percent = 50});
  buffers.release();
  store_marks(buffers, 1, 2);
  EXPECT_FALSE(buffers.has_next());
}

TEST(KeyframeBuffersDeathTest, WantsItsOptionsInRange) {
  const auto make = [](std::size_t receiver, std::size_t playout, int threshold) {
    const KeyframeBuffers buffers({receiver, playout, threshold});
  };
  EXPECT_DEATH(make(0, 1, 40), "broken invariant");
  EXPECT_DEATH(make(10'001, 1, 40), "broken invariant");
  EXPECT_DEATH(make(10, 0, 40), "broken invariant");
  EXPECT_DEATH(make(10, 11, 40), "broken invariant");
  EXPECT_DEATH(make(10, 5, 0), "broken invariant");
  EXPECT_DEATH(make(10, 5, 101), "broken invariant");
}

BufferOptions random_options(Seeded& seeded) {
  const int receiver = seeded.chance(0.3) ? seeded.integer(1, 3) : seeded.integer(1, 120);
  BufferOptions options;
  options.receiver_capacity = static_cast<std::size_t>(receiver);
  options.playout_capacity = static_cast<std::size_t>(seeded.integer(1, receiver));
  options.threshold_percent = seeded.chance(0.3) ? 100 : seeded.integer(1, 100);
  return options;
}

TEST(KeyframeBuffers, KeepsOrderAndCapacitiesInAnySequence) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int round = 0; round < 200; ++round) {
    const BufferOptions options = random_options(seeded);
    KeyframeBuffers buffers(options);
    const double eager = seeded.real(0.2, 0.8);
    int stored = 0;  // the model: a queue holding taken + 1 ... stored
    int taken = 0;
    bool ended = false;
    for (int step = 0; step < 500; ++step) {
      if (!ended && seeded.chance(0.002)) {
        buffers.end_of_stream();
        ended = true;
      } else if (seeded.chance(0.01)) {
        buffers.release();
      } else if (!ended && seeded.chance(eager)) {
        const bool both_full = buffers.room() == 0 && buffers.has_next();
        const Stored result = buffers.store(marked(stored + 1));
        EXPECT_EQ(result == Stored::No, both_full);
        if (result == Stored::Yes) ++stored;
      } else if (const int mark = take_mark(buffers); mark != 0) {
        EXPECT_EQ(mark, ++taken);
      }
      ASSERT_LE(buffers.receiver_fill(), options.receiver_capacity);
      ASSERT_LE(buffers.playout_fill(), options.playout_capacity);
      ASSERT_EQ(buffers.receiver_fill() + buffers.playout_fill(),
                static_cast<std::size_t>(stored - taken));
      ASSERT_EQ(buffers.finished(), ended && stored == taken);
    }
    buffers.end_of_stream();
    while (const int mark = take_mark(buffers)) EXPECT_EQ(mark, ++taken);
    EXPECT_EQ(taken, stored);
    EXPECT_TRUE(buffers.finished());
  }
}

/// A server that sends whenever it may and a player that takes whatever there is, each as often as
/// chance has it: everything comes through, or somebody waits for ever. `window` 0 is stop-and-wait
/// by cases A-D; else room for a window is kept as a level 2 reader does.
void expect_all_comes_through(const BufferOptions& options, std::size_t window, int count,
                              Seeded& seeded) {
  SCOPED_TRACE(::testing::Message()
               << "buffer " << options.receiver_capacity << " playout " << options.playout_capacity
               << " threshold " << options.threshold_percent << " window " << window);
  KeyframeBuffers buffers(options);
  const std::size_t wanted_room = std::min(window, options.receiver_capacity);
  int sent = 0;
  int taken = 0;
  bool kept = false;  // stop-and-wait: the keyframe of case A
  int idle = 0;
  while (taken < count && idle < 3) {
    const int before = sent + taken;
    for (int burst = seeded.integer(1, 100); burst > 0 && sent < count; --burst) {
      if (window > 0) {
        if (buffers.room() < wanted_room) buffers.release();
        if (buffers.room() < wanted_room) break;
      }
      if (buffers.store(marked(sent + 1)) == Stored::No) {
        kept = true;
        break;
      }
      kept = false;
      ++sent;
    }
    if (sent == count) buffers.end_of_stream();
    for (int burst = seeded.integer(1, 100); burst > 0; --burst) {
      const int mark = take_mark(buffers);
      if (mark == 0) break;
      ASSERT_EQ(mark, ++taken);
    }
    idle = sent + taken == before ? idle + 1 : 0;
  }
  EXPECT_EQ(taken, count) << "deadlock" << (kept ? " with a kept keyframe" : "");
  EXPECT_TRUE(buffers.finished());
}

TEST(KeyframeBuffers, NeverDeadlocks) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  constexpr std::array<std::size_t, 6> kSizes{1, 2, 3, 64, 100, 10'000};
  constexpr std::array<std::size_t, 5> kWindows{0, 1, 2, 64, 256};
  for (const std::size_t receiver : kSizes) {
    for (const std::size_t playout : kSizes) {
      if (playout > receiver) continue;
      for (const int threshold : {1, 40, 99, 100}) {
        for (const std::size_t window : kWindows) {
          expect_all_comes_through({receiver, playout, threshold}, window, 300, seeded);
        }
      }
    }
  }
}

TEST(KeyframeBuffers, PlaysWhenTheWindowNeedsMoreRoomThanTheThresholdLeaves) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  expect_all_comes_through({100, 30, 40}, 64, 1000, seeded);
}

}  // namespace
}  // namespace aucast::playback
