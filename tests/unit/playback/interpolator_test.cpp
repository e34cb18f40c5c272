#include "client/playback/interpolator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/seeded.h"

namespace aucast::playback {
namespace {

using aucast::test::Seeded;

TEST(Ease, IsExactAtBothEnds) {
  for (const auto kind : {Interpolation::Linear, Interpolation::Cosine}) {
    EXPECT_EQ(ease(kind, 0), 0.0F);
    EXPECT_EQ(ease(kind, 1), 1.0F);
  }
}

TEST(Ease, StaysAtTheEndsOutside) {
  for (const auto kind : {Interpolation::Linear, Interpolation::Cosine}) {
    EXPECT_EQ(ease(kind, -0.5), 0.0F);
    EXPECT_EQ(ease(kind, 1.5), 1.0F);
  }
}

TEST(Ease, FollowsItsFormula) {
  EXPECT_FLOAT_EQ(ease(Interpolation::Linear, 0.3), 0.3F);
  EXPECT_FLOAT_EQ(ease(Interpolation::Cosine, 0.5), 0.5F);
  EXPECT_FLOAT_EQ(ease(Interpolation::Cosine, 0.25), (1 - std::numbers::sqrt2_v<float> / 2) / 2);
  EXPECT_FLOAT_EQ(ease(Interpolation::Cosine, 1.0 / 3), 0.25F);
}

TEST(Ease, NeverGoesBack) {
  for (const auto kind : {Interpolation::Linear, Interpolation::Cosine}) {
    float before = 0;
    for (int k = 0; k <= 1000; ++k) {
      const float weight = ease(kind, k / 1000.0);
      EXPECT_GE(weight, before) << k;
      EXPECT_LE(weight, 1.0F);
      before = weight;
    }
  }
}

TEST(Interpolate, IsExactAtBothEnds) {
  const std::vector<float> start{0, 0.1F, 2, 1e-30F};
  const std::vector<float> end{1, 0.7F, 0, 3};
  std::vector<float> out(4, -1);
  interpolate(start, end, 0, out);
  EXPECT_EQ(out, start);
  interpolate(start, end, 1, out);
  EXPECT_EQ(out, end);
}

TEST(Interpolate, MeetsTheMiddle) {
  const std::vector<float> start{0, 1, 2};
  const std::vector<float> end{1, 1, 0};
  std::vector<float> out(3);
  interpolate(start, end, 0.5F, out);
  EXPECT_EQ(out, (std::vector<float>{0.5F, 1, 1}));
}

TEST(Interpolate, MayWriteOverAKey) {
  std::vector<float> start{0, 4};
  std::vector<float> end{2, 0};
  interpolate(start, end, 0.25F, start);
  EXPECT_EQ(start, (std::vector<float>{0.5F, 3}));
  interpolate(start, end, 0.5F, end);
  EXPECT_EQ(end, (std::vector<float>{1.25F, 1.5F}));
}

TEST(Interpolate, MayBeOfNothing) {
  std::vector<float> out;
  interpolate({}, {}, 0.5F, out);
  EXPECT_TRUE(out.empty());
}

TEST(Interpolate, NeverLeavesItsKeys) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int round = 0; round < 2000; ++round) {
    const bool still = seeded.chance(0.3);
    const auto from = static_cast<float>(seeded.real(0, 4));
    const auto to = still ? from : static_cast<float>(seeded.real(0, 4));
    const auto weight = static_cast<float>(seeded.real(0, 1));
    const std::vector<float> start{from, to};
    const std::vector<float> end{to, from};
    std::vector<float> out(2);
    interpolate(start, end, weight, out);
    for (const float value : out) {
      EXPECT_GE(value, std::min(from, to));
      EXPECT_LE(value, std::max(from, to));
    }
    if (still) {
      EXPECT_EQ(out[0], from) << "what does not change must not tremble";
    }
  }
}

TEST(InterpolateDeathTest, WantsEqualSizes) {
  std::vector<float> two(2);
  std::vector<float> three(3);
  EXPECT_DEATH(interpolate(two, two, 0, three), "broken invariant");
  EXPECT_DEATH(interpolate(three, two, 0, three), "broken invariant");
}

}  // namespace
}  // namespace aucast::playback
