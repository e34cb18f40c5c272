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

/// The numbers of the moments to show.
std::vector<std::uint64_t> shown(const LiveClock& clock) {
  std::vector<std::uint64_t> numbers;
  for (std::uint64_t n = clock.first_shown(); n < clock.begun(); ++n) numbers.push_back(n);
  return numbers;
}

using Numbers = std::vector<std::uint64_t>;

TEST(LiveClock, BeginsEachMomentWhenTheFaceSetsOut) {
  const auto clock_times = times_of({100ms, 50ms, 200ms});
  LiveClock clock(clock_times, false, kBegin);
  EXPECT_EQ(clock.turn(), 350ms);
  EXPECT_EQ(clock.begun(), 0U);
  EXPECT_EQ(clock.next_at(), kBegin);
  EXPECT_FALSE(clock.advance(kBegin - 1ms));
  EXPECT_TRUE(clock.advance(kBegin));
  EXPECT_EQ(shown(clock), Numbers{0});
  EXPECT_FALSE(clock.advance(kBegin + 99ms));
  EXPECT_TRUE(clock.advance(kBegin + 100ms));
  EXPECT_EQ(shown(clock), Numbers{1});
  EXPECT_EQ(clock.next_at(), kBegin + 150ms);
}

TEST(LiveClock, EndsAfterTheTimeOfTheLastKeyframe) {
  const auto clock_times = times_of({100ms, 50ms});
  LiveClock clock(clock_times, false, kBegin);
  EXPECT_TRUE(clock.advance(kBegin + 149ms));
  EXPECT_FALSE(clock.ended());
  EXPECT_TRUE(clock.advance(kBegin + 150ms));
  EXPECT_TRUE(clock.ended());
  EXPECT_EQ(shown(clock), Numbers{1}) << "it is not shown again, and yet it is the last state";
  EXPECT_FALSE(clock.next_at().has_value());
  EXPECT_FALSE(clock.advance(kBegin + 24h));
}

TEST(LiveClock, StartsAgainAndGoesOnCounting) {
  const auto clock_times = times_of({100ms, 50ms});
  LiveClock clock(clock_times, true, kBegin);
  EXPECT_TRUE(clock.advance(kBegin + 300ms));
  EXPECT_EQ(shown(clock), (Numbers{0, 1, 2, 3, 4}));
  EXPECT_FALSE(clock.advance(kBegin + 300ms));
  EXPECT_FALSE(clock.ended());
}

TEST(LiveClock, PassesThroughMomentsOfNoTime) {
  const auto clock_times = times_of({0ms, 0ms, 10ms});
  LiveClock clock(clock_times, false, kBegin);
  EXPECT_TRUE(clock.advance(kBegin));
  EXPECT_EQ(shown(clock), (Numbers{0, 1, 2}));
  EXPECT_FALSE(clock.advance(kBegin));
  EXPECT_EQ(clock.begun(), 3U) << "nothing has happened since";
  const auto instant_times = times_of({0ms});
  LiveClock instant(instant_times, false, kBegin);
  EXPECT_TRUE(instant.advance(kBegin));
  EXPECT_TRUE(instant.ended());
  EXPECT_EQ(shown(instant), Numbers{0});
}

TEST(LiveClock, LeavesOutWhatIsLongPast) {
  const auto clock_times = times_of({10ms});
  LiveClock clock(clock_times, true, kBegin);
  EXPECT_TRUE(clock.advance(kBegin));
  EXPECT_TRUE(clock.advance(kBegin + 1h));
  EXPECT_EQ(clock.begun(), 360'001U) << "the numbers tell that something was left out";
  EXPECT_EQ(shown(clock).size(), LiveClock::kLiveLagMax / 10ms + 2);
  const auto short_one_times = times_of({10ms, 10ms});
  LiveClock short_one(short_one_times, false, kBegin);
  EXPECT_TRUE(short_one.advance(kBegin + 1h));
  EXPECT_TRUE(short_one.ended());
  EXPECT_EQ(shown(short_one), Numbers{1}) << "the last state is kept";
}

TEST(LiveClock, OfALoopThatIsDueManyTimesOverItShowsTheNewest) {
  for (const std::size_t size : {2U, 3U, 100U, 1000U}) {
    std::vector<Milliseconds> times(size, 0ms);
    times.back() = 1ms;
    const auto clock_times = times_of(times);
    LiveClock quick(clock_times, true, kBegin);
    LiveClock patient(clock_times, true, kBegin);
    Instant now = kBegin;
    for (const Milliseconds pause : {0ms, 1ms, 2ms, 300ms, 900ms, 5000ms}) {
      std::uint64_t first = patient.begun();
      for (const Instant asked = now; now <= asked + pause; now += 1ms) {
        patient.advance(now);
      }
      now -= 1ms;
      // What has ended more than kLiveLagMax ago, a turn a millisecond.
      const auto past = (now - kBegin) / 1ms - LiveClock::kLiveLagMax / 1ms;
      if (past > 0) first = std::max(first, static_cast<std::uint64_t>(past) * size);
      SCOPED_TRACE(std::to_string(size) + " keyframes, after " + std::to_string(pause.count()));
      quick.advance(now);
      EXPECT_EQ(quick.begun(), patient.begun());
      EXPECT_EQ(quick.next_at(), patient.next_at());
      const std::size_t most = std::min<std::size_t>(patient.begun() - first, LiveClock::kShownMax);
      EXPECT_EQ(shown(quick).size(), std::max<std::size_t>(most, 1));
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
    clock.advance(now);
    const std::uint64_t newest = clock.begun() - 1;
    const std::size_t keyframe = newest % times.size();
    Instant begin = kBegin + sum * (newest / times.size());
    for (std::size_t k = 0; k < keyframe; ++k) begin += times[k];
    ASSERT_LE(begin, now);
    ASSERT_GT(begin + times[keyframe], now);
  }
}

TEST(LiveClockDeathTest, RefusesWhatCannotRun) {
  EXPECT_DEATH(LiveClock({}, false, kBegin), "");
  const auto no_time = times_of({0ms, 0ms});
  EXPECT_DEATH(LiveClock(no_time, true, kBegin), "");
}

}  // namespace
}  // namespace aucast::protocol
