#include "common/sources/dead_band.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "common/action_unit.h"

namespace aucast::sources {
namespace {

AuFrame smile(int percent) {
  AuFrame frame;
  frame.left[12] = frame.right[12] = static_cast<float>(percent) / 100;
  return frame;
}

int shown(DeadBand& band, int percent) {
  return static_cast<int>(std::lround(band.settle(smile(percent)).left[12] * 100));
}

TEST(DeadBand, SmallChangesAreNotSeenLargeOnesWhole) {
  DeadBand band(PerAu(3));
  EXPECT_EQ(shown(band, 50), 50);
  EXPECT_EQ(shown(band, 52), 50);
  EXPECT_EQ(shown(band, 48), 50);
  EXPECT_EQ(shown(band, 53), 53);
  EXPECT_EQ(shown(band, 51), 53);
  EXPECT_EQ(shown(band, 50), 50);
}

TEST(DeadBand, ASlowChangeIsFollowedWithinTheBand) {
  DeadBand band(PerAu(2));
  for (int percent = 0; percent <= 100; ++percent) {
    EXPECT_LE(std::abs(shown(band, percent) - percent), 1) << percent;
  }
}

TEST(DeadBand, NothingIsLeftOfWhatGoesToZero) {
  DeadBand band(PerAu(10));
  EXPECT_EQ(shown(band, 12), 12);
  EXPECT_EQ(shown(band, 5), 12);
  EXPECT_EQ(shown(band, 0), 0);
}

TEST(DeadBand, ZeroAndOneLeaveEverything) {
  for (const int percent : {0, 1}) {
    DeadBand band{PerAu(percent)};
    for (const int value : {50, 51, 50, 1, 0, 100}) EXPECT_EQ(shown(band, value), value);
  }
}

TEST(DeadBand, EachAuAndSideHasItsOwn) {
  PerAu percent(0);
  percent.set({12, Side::Left}, 10);
  DeadBand band(percent);
  static_cast<void>(band.settle(smile(50)));
  const AuFrame shown = band.settle(smile(45));
  EXPECT_FLOAT_EQ(shown.left[12], 0.5F);
  EXPECT_FLOAT_EQ(shown.right[12], 0.45F);
}

TEST(DeadBand, AStreamKeepsItsTimes) {
  protocol::StreamFile stream;
  for (const std::uint8_t percent : std::vector<std::uint8_t>{50, 51, 53}) {
    protocol::Keyframe keyframe;
    keyframe.terms = {{12, Side::Both, percent}};
    keyframe.time_ms = percent;
    stream.keyframes.push_back(keyframe);
  }
  apply_dead_band(stream, PerAu(2));
  ASSERT_EQ(stream.keyframes.size(), 3U);
  EXPECT_EQ(stream.keyframes[1].terms, (std::vector<AuTerm>{{12, Side::Both, 50}}));
  EXPECT_EQ(stream.keyframes[1].time_ms, 51U);
  EXPECT_EQ(stream.keyframes[2].terms, (std::vector<AuTerm>{{12, Side::Both, 53}}));
}

}  // namespace
}  // namespace aucast::sources
