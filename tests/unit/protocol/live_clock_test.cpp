#include "protocol/live_clock.h"

#include <gtest/gtest.h>

#include "tests/support/seeded.h"

namespace aucast::protocol {
namespace {

using namespace std::chrono_literals;
using test::Seeded;

const Instant kBegin = Instant{} + 1h;

std::vector<KeyframeTime> times_of(const std::vector<Milliseconds>& times) {
  std::vector<KeyframeTime> narrow;
  for (const Milliseconds time : times) narrow.emplace_back(time.count());
  return narrow;
}

TEST(LiveClock, BeginsEachMomentWhenTheFaceSetsOut) {
  const auto clock_times = times_of({100ms, 50ms, 200ms});
  LiveClock clock(clock_times, false, kBegin);
  EXPECT_EQ(clock.turn(), 350ms);
  EXPECT_FALSE(clock.newest().has_value());
  EXPECT_EQ(clock.next_at(), kBegin);
  EXPECT_FALSE(clock.advance(kBegin - 1ms));
  EXPECT_TRUE(clock.advance(kBegin));
  EXPECT_EQ(clock.newest(), (LiveClock::Moment{0, 0}));
  EXPECT_FALSE(clock.advance(kBegin + 99ms));
  EXPECT_TRUE(clock.advance(kBegin + 100ms));
  EXPECT_EQ(clock.newest(), (LiveClock::Moment{1, 1}));
  EXPECT_EQ(clock.next_at(), kBegin + 150ms);
}

TEST(LiveClock, EndsAfterTheTimeOfTheLastKeyframe) {
  const auto clock_times = times_of({100ms, 50ms});
  LiveClock clock(clock_times, false, kBegin);
  while (clock.advance(kBegin + 149ms)) {
  }
  EXPECT_FALSE(clock.ended());
  EXPECT_TRUE(clock.advance(kBegin + 150ms));
  EXPECT_TRUE(clock.ended());
  EXPECT_EQ(clock.newest(), (LiveClock::Moment{1, 1}));
  EXPECT_FALSE(clock.next_at().has_value());
  EXPECT_FALSE(clock.advance(kBegin + 24h));
}

TEST(LiveClock, StartsAgainAndGoesOnCounting) {
  const auto clock_times = times_of({100ms, 50ms});
  LiveClock clock(clock_times, true, kBegin);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(clock.advance(kBegin + 300ms));
  EXPECT_EQ(clock.newest(), (LiveClock::Moment{4, 0}));
  EXPECT_FALSE(clock.advance(kBegin + 300ms));
  EXPECT_FALSE(clock.ended());
}

TEST(LiveClock, PassesThroughMomentsOfNoTime) {
  const auto clock_times = times_of({0ms, 0ms, 10ms});
  LiveClock clock(clock_times, true, kBegin);
  for (std::size_t keyframe : {0U, 1U, 2U}) {
    EXPECT_TRUE(clock.advance(kBegin));
    EXPECT_EQ(clock.newest()->keyframe, keyframe);
  }
  EXPECT_FALSE(clock.advance(kBegin));
  const auto instant_times = times_of({0ms});
  LiveClock instant(instant_times, false, kBegin);
  EXPECT_TRUE(instant.advance(kBegin));
  EXPECT_TRUE(instant.advance(kBegin));
  EXPECT_TRUE(instant.ended());
}

TEST(LiveClock, TellsOfAllThatItPassedThrough) {
  const auto clock_times = times_of({0ms, 0ms, 10ms});
  LiveClock clock(clock_times, false, kBegin);
  EXPECT_FALSE(clock.advance_all(kBegin - 1ms));
  EXPECT_TRUE(clock.advance_all(kBegin));
  ASSERT_EQ(clock.passed().size(), 3U);
  for (std::size_t keyframe : {0U, 1U, 2U}) EXPECT_EQ(clock.passed()[keyframe].number, keyframe);
  EXPECT_EQ(clock.passed().back(), clock.newest());
  EXPECT_FALSE(clock.advance_all(kBegin));
  EXPECT_EQ(clock.passed().size(), 3U) << "nothing has happened since";
  EXPECT_TRUE(clock.advance_all(kBegin + 10ms));
  EXPECT_TRUE(clock.ended());
  EXPECT_TRUE(clock.passed().empty());
}

TEST(LiveClock, LeavesOutWhatIsLongPast) {
  const auto clock_times = times_of({10ms});
  LiveClock clock(clock_times, true, kBegin);
  EXPECT_TRUE(clock.advance(kBegin));
  int steps = 0;
  while (clock.advance(kBegin + 1h)) ++steps;
  EXPECT_LE(steps, LiveClock::kLiveLagMax / 10ms + 2);
  EXPECT_EQ(clock.newest()->number, 360'000U) << "the numbers tell that something was left out";
  const auto short_one_times = times_of({10ms, 10ms});
  LiveClock short_one(short_one_times, false, kBegin);
  EXPECT_TRUE(short_one.advance(kBegin + 1h));
  EXPECT_TRUE(short_one.ended());
  EXPECT_EQ(short_one.newest()->keyframe, 1U) << "the last state is kept";
}

TEST(LiveClock, OfALoopThatIsDueManyTimesOverItKeepsTheNewest) {
  for (const std::size_t size : {2U, 3U, 100U, 1000U}) {
    std::vector<Milliseconds> times(size, 0ms);
    times.back() = 1ms;
    const auto clock_times = times_of(times);
    LiveClock quick(clock_times, true, kBegin);
    LiveClock patient(clock_times, true, kBegin);
    Instant now = kBegin;
    for (const Milliseconds pause : {0ms, 1ms, 2ms, 300ms, 900ms, 5000ms}) {
      now += pause;
      EXPECT_EQ(quick.advance_all(now), patient.advance(now));
      std::vector<LiveClock::Moment> all(patient.passed().begin(), patient.passed().end());
      while (patient.advance(now)) {
        all.insert(all.end(), patient.passed().begin(), patient.passed().end());
      }
      EXPECT_EQ(quick.newest(), patient.newest());
      EXPECT_EQ(quick.next_at(), patient.next_at());
      const auto kept = quick.passed();
      ASSERT_EQ(kept.size(), std::min(all.size(), LiveClock::kPassedMax));
      EXPECT_TRUE(std::equal(kept.rbegin(), kept.rend(), all.rbegin()))
          << size << " keyframes, after " << pause.count() << " ms";
    }
  }
}

TEST(LiveClock, NeverDriftsWhateverTheMomentsOfAsking) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  std::vector<Milliseconds> times;
  Milliseconds sum{0};
  for (int i = 0; i < 50; ++i) sum += times.emplace_back(seeded.integer(1, 400));
  const auto narrow = times_of(times);
  LiveClock clock(narrow, true, kBegin);
  Instant now = kBegin;
  for (int i = 0; i < 5000; ++i) {
    now += Milliseconds(seeded.integer(0, 900));
    while (clock.advance(now)) {
    }
    const auto& newest = *clock.newest();
    Instant begin = kBegin + sum * (newest.number / times.size());
    for (std::size_t k = 0; k < newest.keyframe; ++k) begin += times[k];
    ASSERT_EQ(newest.keyframe, newest.number % times.size());
    ASSERT_LE(begin, now);
    ASSERT_GT(begin + times[newest.keyframe], now);
  }
}

TEST(LiveClockDeathTest, RefusesWhatCannotRun) {
  EXPECT_DEATH(LiveClock({}, false, kBegin), "");
  const auto no_time = times_of({0ms, 0ms});
  EXPECT_DEATH(LiveClock(no_time, true, kBegin), "");
}

}  // namespace
}  // namespace aucast::protocol
