#include "common/sources/live_queue.h"

#include <gtest/gtest.h>

#include "tests/support/steady_time.h"

namespace aucast::sources {
namespace {

LiveKeyframe at(double seconds, bool begins = false, bool clocked = true) {
  LiveKeyframe keyframe;
  keyframe.keyframe.time_ms = static_cast<std::uint32_t>(seconds * 1000) + 1;
  keyframe.seconds = seconds;
  keyframe.begins = begins;
  keyframe.clocked = clocked;
  return keyframe;
}

std::size_t popped(LiveQueue& queue, double now) {
  std::size_t count = 0;
  while (queue.pop(test::at_second(now))) ++count;
  return count;
}

TEST(LiveQueue, WhatComesInTimeGoesAtOnce) {
  LiveQueue queue;
  for (int i = 0; i < 300; ++i) {
    const double now = 50 + i / 30.0 + (i % 7) * 0.01;
    queue.push(at(i / 30.0, i == 0), test::at_second(now));
    EXPECT_EQ(popped(queue, now), 1U) << i;
  }
}

TEST(LiveQueue, AfterAHitchEverythingGoesAtOnce) {
  LiveQueue queue;
  queue.push(at(0, true), test::at_second(50));
  for (int i = 1; i < 90; ++i) queue.push(at(i / 30.0), test::at_second(53));
  EXPECT_EQ(popped(queue, 53), 90U);
}

TEST(LiveQueue, ARecordingThatIsPouredInPlaysAtItsOwnSpeed) {
  LiveQueue queue;
  for (int i = 0; i < 300; ++i) queue.push(at(i / 30.0, i == 0), test::at_second(50));
  EXPECT_EQ(popped(queue, 50), 31U);
  EXPECT_EQ(popped(queue, 51.001), 30U);
  EXPECT_EQ(popped(queue, 58.9), 237U);
  EXPECT_EQ(popped(queue, 59), 2U);
  EXPECT_FALSE(queue.due().has_value());
}

TEST(LiveQueue, ASecondRecordingFollowsTheFirst) {
  LiveQueue queue;
  for (int i = 0; i < 60; ++i) queue.push(at(i / 30.0, i == 0), test::at_second(50));
  for (int i = 0; i < 60; ++i) queue.push(at(2 + i / 30.0, i == 0), test::at_second(50));
  EXPECT_EQ(popped(queue, 52.5), 107U);
  // After a pause of the source its clock begins anew, so nothing is late.
  EXPECT_EQ(popped(queue, 60), 13U);
  queue.push(at(4, true), test::at_second(90));
  EXPECT_EQ(popped(queue, 90), 1U);
}

TEST(LiveQueue, WhoHasNoClockIsNeverLate) {
  LiveQueue queue;
  queue.push(at(0, true, false), test::at_second(50));
  EXPECT_EQ(popped(queue, 50), 1U);
  // An hour later lines are poured in: they take their time from now.
  for (int i = 0; i < 30; ++i) queue.push(at(0.25 + i * 0.25, false, false), test::at_second(3650));
  EXPECT_EQ(popped(queue, 3650), 5U);
  EXPECT_EQ(popped(queue, 3651), 4U);
}

TEST(LiveQueue, SkippingLeavesTheLatest) {
  LiveQueue queue;
  for (int i = 0; i < 300; ++i) queue.push(at(i / 30.0, i == 0), test::at_second(50));
  queue.skip_to_last(test::at_second(50));
  EXPECT_EQ(queue.size(), 1U);
  EXPECT_EQ(popped(queue, 50), 1U);
  queue.push(at(10), test::at_second(50.03));
  EXPECT_EQ(popped(queue, 50.03), 1U);
}

}  // namespace
}  // namespace aucast::sources
