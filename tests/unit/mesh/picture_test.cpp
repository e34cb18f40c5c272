#include "common/mesh/picture.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace aucast::mesh {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Square, CanBeSeenWhenItIsTurnedOrBesideThePicture) {
  EXPECT_TRUE(can_be_seen({320, 240, 200, 0}));
  EXPECT_TRUE(can_be_seen({-320, 2400, 1, -3}));
}

TEST(Square, CannotBeSeenWithoutNumbers) {
  for (const double wrong : {kNan, kInfinity, -kInfinity}) {
    EXPECT_FALSE(can_be_seen({wrong, 240, 200, 0}));
    EXPECT_FALSE(can_be_seen({320, wrong, 200, 0}));
    EXPECT_FALSE(can_be_seen({320, 240, wrong, 0}));
    EXPECT_FALSE(can_be_seen({320, 240, 200, wrong}));
  }
}

TEST(Square, CannotBeSeenFarAwayOrWithoutASize) {
  for (const double far : {1e30, -1e30, 1e6, -1e6}) {
    EXPECT_FALSE(can_be_seen({far, 240, 200, 0}));
    EXPECT_FALSE(can_be_seen({320, far, 200, 0}));
    EXPECT_FALSE(can_be_seen({320, 240, far, 0}));
  }
  EXPECT_FALSE(can_be_seen({320, 240, 0.5, 0}));
}

TEST(Square, ShowsBlackOutsideOfThePicture) {
  const std::vector<std::uint8_t> white(3, 255);
  std::vector<float> shown(3, -1);
  sample_square({1, 1, white}, {0.5, 0.5, 1, 0}, 1, 0, 1, shown);
  EXPECT_EQ(shown, std::vector<float>(3, 1));
  for (const double far : {-999'999.0, 999'999.0}) {
    const Square square{far, far, 1, 0};
    ASSERT_TRUE(can_be_seen(square));
    sample_square({1, 1, white}, square, 1, 0, 1, shown);
    EXPECT_EQ(shown, std::vector<float>(3, 0)) << far;
  }
}

}  // namespace
}  // namespace aucast::mesh
