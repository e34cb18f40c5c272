#include "common/sources/resample.h"

#include <gtest/gtest.h>

#include "tests/support/seeded.h"

namespace aucast::sources {
namespace {

protocol::Keyframe smile_for(std::uint8_t percent, std::optional<std::uint32_t> time_ms) {
  return {{{12, Side::Both, percent}}, false, time_ms, std::nullopt};
}

int percent_of(const protocol::Keyframe& keyframe) {
  return keyframe.terms.front().number == 12 ? keyframe.terms.front().percent : 0;
}

TEST(Resample, GoesInStraightLinesFromNeutralOn) {
  const auto stream = resample({{smile_for(80, 100), smile_for(40, 100)}}, 20, 250);
  ASSERT_EQ(stream.keyframes.size(), 4U);
  EXPECT_EQ(percent_of(stream.keyframes[0]), 40);
  EXPECT_EQ(percent_of(stream.keyframes[1]), 80);
  EXPECT_EQ(percent_of(stream.keyframes[2]), 60);
  EXPECT_EQ(percent_of(stream.keyframes[3]), 40);
  for (const auto& each : stream.keyframes) EXPECT_EQ(each.time_ms, 50U);
}

TEST(Resample, LastKeyframeIsTheStreamsOwnEnd) {
  const auto stream = resample({{smile_for(80, 110)}}, 20, 250);
  ASSERT_EQ(stream.keyframes.size(), 3U);
  EXPECT_EQ(stream.keyframes[2].time_ms, 10U);
  EXPECT_EQ(percent_of(stream.keyframes[2]), 80);
}

TEST(Resample, UntimedKeyframesTakeTheGivenTime) {
  const auto stream = resample({{smile_for(80, std::nullopt)}}, 1, 250);
  ASSERT_EQ(stream.keyframes.size(), 1U);
  EXPECT_EQ(stream.keyframes[0].time_ms, 250U);
}

TEST(Resample, TimesNeverDriftAtAnyRate) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int round = 0; round < 30; ++round) {
    protocol::StreamFile stream;
    for (int index = 0; index < 50; ++index) {
      stream.keyframes.push_back(smile_for(static_cast<std::uint8_t>(seeded.integer(1, 100)),
                                           static_cast<std::uint32_t>(seeded.integer(1, 300))));
    }
    const double rate = seeded.real(0.1, 1000);
    const auto resampled = resample(stream, rate, 250);
    EXPECT_EQ(protocol::media_ms(resampled, 250), protocol::media_ms(stream, 250));
    EXPECT_EQ(percent_of(resampled.keyframes.back()), percent_of(stream.keyframes.back()));
    double place = 0;
    for (std::size_t index = 0; index + 1 < resampled.keyframes.size(); ++index) {
      place += *resampled.keyframes[index].time_ms;
      ASSERT_NEAR(place, static_cast<double>(index + 1) * 1000 / rate, 0.5 + 1e-6);
      ASSERT_GT(*resampled.keyframes[index].time_ms, 0U);
    }
  }
}

}  // namespace
}  // namespace aucast::sources
