// The lines that a served stream is kept as.
#include "common/sources/record_timeline.h"

#include <gtest/gtest.h>

#include "protocol/stream_file.h"
#include "tests/support/steady_time.h"

namespace aucast::sources {
namespace {

using test::at_second;

protocol::Keyframe au_keyframe(std::uint8_t au, std::uint32_t time_ms) {
  protocol::Keyframe made;
  made.terms = {{au, Side::Both, 100}};
  made.time_ms = time_ms;
  return made;
}

std::string lines(const std::vector<protocol::Keyframe>& keyframes) {
  std::string all;
  for (const auto& line : keyframes) all += protocol::format_stream_line(line) + " ";
  return all;
}

constexpr bool kFree = true;

TEST(RecordTimeline, WhatFollowsInTimeIsKeptAsItIs) {
  RecordTimeline record;
  for (int i = 0; i < 1000; ++i) {
    // Up to 90 ms late, as processes are.
    const double now = 50 + i * 0.04 + (i % 10) * 0.01;
    EXPECT_EQ(lines(record.add(au_keyframe(12, 40), at_second(now), kFree)), "12;40 ") << i;
  }
}

TEST(RecordTimeline, APauseIsKeptAsTheFaceThatStood) {
  RecordTimeline record;
  EXPECT_EQ(lines(record.add(au_keyframe(12, 40), at_second(50), kFree)), "12;40 ");
  EXPECT_EQ(lines(record.add(au_keyframe(6, 100), at_second(51.04), kFree)), "12;1000 6;100 ");
  // The pause before is made up for: this one is in time.
  EXPECT_EQ(lines(record.add(au_keyframe(4, 100), at_second(51.14), kFree)), "4;100 ");
}

TEST(RecordTimeline, WhatTheSourcesClockTiesTogetherIsOnlyLate) {
  RecordTimeline record;
  static_cast<void>(record.add(au_keyframe(12, 40), at_second(50), kFree));
  EXPECT_EQ(lines(record.add(au_keyframe(6, 40), at_second(53), !kFree)), "6;40 ");
}

TEST(RecordTimeline, WhatWasSentAheadIsNoPause) {
  RecordTimeline record;
  for (int i = 0; i < 25; ++i)
    static_cast<void>(record.add(au_keyframe(12, 40), at_second(50), kFree));
  EXPECT_EQ(lines(record.add(au_keyframe(6, 100), at_second(50.9), kFree)), "6;100 ");
}

TEST(RecordTimeline, AnEndForTheClientsIsNotKept) {
  RecordTimeline record;
  static_cast<void>(record.add(au_keyframe(12, 40), at_second(50), kFree));
  record.end();
  EXPECT_EQ(lines(record.add(au_keyframe(6, 40), at_second(90'000), kFree)), "6;40 ");
  EXPECT_EQ(lines(record.add(au_keyframe(4, 40), at_second(90'000.04), kFree)), "4;40 ");
}

TEST(RecordTimeline, PausesOfHoursAreSeveralLines) {
  RecordTimeline record;
  static_cast<void>(record.add(au_keyframe(12, 1000), at_second(0), kFree));
  EXPECT_EQ(lines(record.add(au_keyframe(6, 40), at_second(9001), kFree)),
            "12;3600000 12;3600000 12;1800000 6;40 ");
}

}  // namespace
}  // namespace aucast::sources
