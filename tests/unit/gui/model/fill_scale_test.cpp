#include "client/gui/model/fill_scale.h"

#include <gtest/gtest.h>

namespace aucast::gui {
namespace {

TEST(FillScale, IsARoundNumberOfSetsThatHoldsAllOfIt) {
  const BufferBar buffer{0, 1000, 0};
  EXPECT_EQ(fill_scale({}, buffer), 5U);
  EXPECT_EQ(fill_scale({0.005F, 0.001F}, buffer), 5U);
  EXPECT_EQ(fill_scale({0.001F, 0.006F}, buffer), 10U);
  EXPECT_EQ(fill_scale({0.011F}, buffer), 20U);
  EXPECT_EQ(fill_scale({0.021F}, buffer), 50U);
  EXPECT_EQ(fill_scale({0.051F}, buffer), 100U);
  EXPECT_EQ(fill_scale({0.101F}, buffer), 200U);
  EXPECT_EQ(fill_scale({0.201F}, buffer), 500U);
  EXPECT_EQ(fill_scale({1}, buffer), 1000U);
}

TEST(FillScale, HasRoomForTheThreshold) {
  EXPECT_EQ(fill_scale({0.02F}, {2, 100, 40}), 50U);
}

TEST(FillScale, IsNotMoreThanTheBufferHolds) {
  EXPECT_EQ(fill_scale({}, {0, 3, 0}), 3U);
  EXPECT_EQ(fill_scale({1}, {70, 70, 0}), 70U);
  EXPECT_EQ(fill_scale({}, {0, 0, 0}), 1U);
}

}  // namespace
}  // namespace aucast::gui
