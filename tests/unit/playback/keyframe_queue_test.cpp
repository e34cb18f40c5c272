#include "client/playback/keyframe_queue.h"

#include <deque>
#include <optional>

#include <gtest/gtest.h>

#include "tests/support/seeded.h"
#include "tests/unit/playback/marked.h"

namespace aucast::playback {
namespace {

using namespace std::chrono_literals;
using aucast::test::Seeded;
using test::mark_of;
using test::marked;

TEST(KeyframeQueue, FillsThePlayoutBufferOnlyWhenItIsEmpty) {
  KeyframeQueue queue(5, 2);
  for (int mark = 1; mark <= 4; ++mark) queue.push(marked(mark));
  EXPECT_EQ(queue.playout_fill(), 0U);
  EXPECT_EQ(queue.room(), 1U);
  queue.fill_playout();
  EXPECT_EQ(queue.playout_fill(), 2U);
  EXPECT_EQ(mark_of(queue.pop()), 1);
  queue.fill_playout();
  EXPECT_EQ(queue.playout_fill(), 1U) << "it still has one";
  EXPECT_EQ(mark_of(queue.pop()), 2);
  EXPECT_EQ(queue.playout_fill(), 2U) << "it ran empty";
  EXPECT_EQ(queue.room(), 5U);
}

TEST(KeyframeQueue, DropsTheOldestWhereverThatIs) {
  KeyframeQueue queue(5, 2);
  for (int mark = 1; mark <= 4; ++mark) queue.push(marked(mark));
  queue.drop();
  EXPECT_EQ(queue.receiver_fill(), 3U);
  queue.fill_playout();
  queue.drop();
  EXPECT_EQ(queue.playout_fill(), 2U) << "the receiver's oldest has followed";
  EXPECT_EQ(queue.receiver_fill(), 0U);
  queue.drop();
  EXPECT_EQ(queue.playout_fill(), 1U);
  EXPECT_EQ(mark_of(queue.newest()), 4);
  EXPECT_EQ(mark_of(queue.pop()), 4);
}

TEST(KeyframeQueue, CountsTheTimeOfUntimedKeyframesAnewWhenItChanges) {
  KeyframeQueue queue(5, 2);
  queue.push(marked(1));
  queue.push(marked(2, 40ms));
  EXPECT_EQ(queue.time(), 290ms);
  queue.set_untimed(100ms);
  EXPECT_EQ(queue.time(), 140ms);
  queue.drop();
  EXPECT_EQ(queue.time(), 40ms);
}

/// The model: two queues, and a sum that is made anew each time.
TEST(KeyframeQueue, AgreesWithTwoQueuesInAnySequence) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int round = 0; round < 100; ++round) {
    const int capacity = seeded.integer(1, 40);
    const int playout_capacity = seeded.integer(1, capacity);
    KeyframeQueue queue(static_cast<std::size_t>(capacity),
                        static_cast<std::size_t>(playout_capacity));
    std::deque<Keyframe> receiver;
    std::deque<Keyframe> playout;
    Milliseconds untimed = 250ms;
    const auto follow = [&] {
      playout.push_back(receiver.front());
      receiver.pop_front();
    };
    const auto fill = [&] {
      if (!playout.empty()) return;
      while (!receiver.empty() && playout.size() < static_cast<std::size_t>(playout_capacity)) {
        follow();
      }
    };
    int pushed = 0;
    for (int step = 0; step < 300; ++step) {
      if (queue.room() > 0 && seeded.chance(0.5)) {
        receiver.push_back(marked(++pushed));
        if (seeded.chance(0.5)) receiver.back().time = Milliseconds(seeded.integer(0, 500));
        queue.push(receiver.back());
      } else if (seeded.chance(0.1)) {
        untimed = Milliseconds(seeded.integer(1, 500));
        queue.set_untimed(untimed);
      } else if (seeded.chance(0.3)) {
        queue.fill_playout();
        fill();
      } else if (seeded.chance(0.2) && queue.size() > 0) {
        queue.drop();
        if (playout.empty()) {
          receiver.pop_front();
        } else {
          playout.pop_front();
          if (!receiver.empty()) follow();
        }
      } else if (!playout.empty()) {
        ASSERT_EQ(queue.pop().aus, playout.front().aus);
        playout.pop_front();
        fill();
      }
      ASSERT_EQ(queue.receiver_fill(), receiver.size());
      ASSERT_EQ(queue.playout_fill(), playout.size());
      Milliseconds sum{0};
      for (const Keyframe& one : receiver) sum += one.time.value_or(untimed);
      for (const Keyframe& one : playout) sum += one.time.value_or(untimed);
      ASSERT_EQ(queue.time(), sum);
    }
  }
}

}  // namespace
}  // namespace aucast::playback
