#include "common/sources/timeline.h"

#include <gtest/gtest.h>

#include "tests/support/seeded.h"

namespace aucast::sources {
namespace {

AuFrame smile_of(float intensity) {
  AuFrame frame = no_data();
  frame.left[12] = frame.right[12] = intensity;
  return frame;
}

int percent_of_12(const protocol::Keyframe& keyframe) {
  for (const AuTerm& term : keyframe.terms) {
    if (term.number == 12) return term.percent;
  }
  return 0;
}

std::uint64_t place_of(const protocol::StreamFile& stream, std::size_t index) {
  std::uint64_t place = 0;
  for (std::size_t at = 1; at <= index; ++at) place += *stream.keyframes[at].time_ms;
  return place;
}

TEST(Timeline, DurationsAreDifferencesOfRoundedPlaces) {
  Timeline timeline;
  for (int row = 0; row < 4; ++row) EXPECT_TRUE(timeline.add(row / 30.0, smile_of(0.5F)));
  const auto stream = timeline.finish();
  ASSERT_EQ(stream.keyframes.size(), 4U);
  EXPECT_EQ(stream.keyframes[0].time_ms, 33U) << "the usual time";
  EXPECT_EQ(stream.keyframes[1].time_ms, 33U);
  EXPECT_EQ(stream.keyframes[2].time_ms, 34U);
  EXPECT_EQ(stream.keyframes[3].time_ms, 33U);
}

TEST(Timeline, TimesNeverDrift) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int round = 0; round < 20; ++round) {
    Timeline timeline;
    const double step = seeded.real(0.002, 0.2);
    std::vector<double> moments;
    double seconds = 0;
    for (int row = 0; row < 2000; ++row) {
      if (timeline.add(seconds, smile_of(0.5F))) moments.push_back(seconds);
      seconds += step * seeded.real(0.5, 1.5);
    }
    const auto stream = timeline.finish();
    ASSERT_EQ(stream.keyframes.size(), moments.size());
    std::uint64_t place = 0;
    for (std::size_t index = 1; index < moments.size(); ++index) {
      place += *stream.keyframes[index].time_ms;
      ASSERT_NEAR(static_cast<double>(place), moments[index] * 1000, 0.5 + 1e-6);
    }
  }
}

TEST(Timeline, RowsOfTheSameMillisecondAreLeftOut) {
  Timeline timeline;
  EXPECT_TRUE(timeline.add(0, smile_of(0.1F)));
  EXPECT_FALSE(timeline.add(0.0003, smile_of(0.2F)));
  EXPECT_TRUE(timeline.add(0.002, smile_of(0.3F)));
  EXPECT_EQ(timeline.finish().keyframes.size(), 2U);
}

TEST(Timeline, OneRowAloneIsUntimed) {
  Timeline timeline;
  EXPECT_TRUE(timeline.add(0, smile_of(1)));
  const auto stream = timeline.finish();
  ASSERT_EQ(stream.keyframes.size(), 1U);
  EXPECT_FALSE(stream.keyframes[0].time_ms);
}

TEST(Timeline, RemainingHoldsThenEasesThenIsGone) {
  EXPECT_EQ(remaining(0), 1);
  EXPECT_EQ(remaining(kHoldSeconds), 1);
  EXPECT_NEAR(remaining(kHoldSeconds + kEaseSeconds / 4), 0.75, 1e-9);
  EXPECT_EQ(remaining(kHoldSeconds + kEaseSeconds), 0);
  EXPECT_EQ(remaining(1e9), 0);
}

TEST(Timeline, RowsWithoutDataHoldThenEaseToNeutral) {
  Timeline timeline;
  timeline.add(0, smile_of(0.8F));
  for (int row = 1; row <= 20; ++row) timeline.add(row / 10.0, no_data());
  const auto stream = timeline.finish();
  EXPECT_EQ(percent_of_12(stream.keyframes[5]), 80) << "held for half a second";
  EXPECT_EQ(percent_of_12(stream.keyframes[10]), 40) << "half way";
  EXPECT_EQ(percent_of_12(stream.keyframes[15]), 0);
  EXPECT_EQ(percent_of_12(stream.keyframes[20]), 0);
}

TEST(Timeline, AnAuWithoutDataHoldsWhileOthersGoOn) {
  Timeline timeline;
  AuFrame both = smile_of(0.8F);
  both.left[1] = both.right[1] = 0.5F;
  timeline.add(0, both);
  timeline.add(0.1, smile_of(0.6F));
  const auto stream = timeline.finish();
  EXPECT_EQ(frame_from_terms(stream.keyframes[1].terms).left[1], 0.5F);
  EXPECT_EQ(percent_of_12(stream.keyframes[1]), 60);
}

TEST(Timeline, MissingRowsAreBridgedToNeutralAndBack) {
  Timeline timeline;
  timeline.add(0, smile_of(0.8F));
  timeline.add(0.1, smile_of(0.8F));
  timeline.add(10, smile_of(0.6F));
  const auto stream = timeline.finish();
  ASSERT_EQ(stream.keyframes.size(), 6U);
  EXPECT_EQ(place_of(stream, 2), 600U);
  EXPECT_EQ(percent_of_12(stream.keyframes[2]), 80);
  EXPECT_EQ(place_of(stream, 3), 1600U);
  EXPECT_EQ(percent_of_12(stream.keyframes[3]), 0);
  EXPECT_EQ(place_of(stream, 4), 9900U);
  EXPECT_EQ(percent_of_12(stream.keyframes[4]), 0);
  EXPECT_EQ(place_of(stream, 5), 10000U);
  EXPECT_EQ(percent_of_12(stream.keyframes[5]), 60);
}

TEST(Timeline, PausesOfHoursKeepToTheLongestKeyframe) {
  Timeline timeline;
  timeline.add(0, smile_of(0.8F));
  timeline.add(10'000, smile_of(0.6F));
  const auto stream = timeline.finish();
  for (const auto& keyframe : stream.keyframes) EXPECT_LE(*keyframe.time_ms, 3'600'000U);
  EXPECT_EQ(place_of(stream, stream.keyframes.size() - 1), 10'000'000U);
}

TEST(Timeline, PausesOfAnyLengthEnd) {
  for (const double begin : {0.0, 0.633, 1.7e9}) {
    for (const double pause : {18'010.7, 20'090.0, 86'399.9}) {
      Timeline timeline;
      timeline.add(begin, smile_of(0.8F));
      timeline.add(begin + 0.033, smile_of(0.8F));
      timeline.add(begin + pause, smile_of(0.6F));
      const auto stream = timeline.finish();
      EXPECT_LE(stream.keyframes.size(), 32U) << begin << " " << pause;
      for (const auto& keyframe : stream.keyframes) EXPECT_LE(*keyframe.time_ms, 3'600'000U);
    }
  }
}

}  // namespace
}  // namespace aucast::sources
