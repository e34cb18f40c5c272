#include "client/gui/editing/transition.h"

#include <gtest/gtest.h>

#include "tests/support/manual_clock.h"

namespace aucast::gui {
namespace {

using Face = std::vector<float>;

TEST(Transition, GoesInStepsFromOneFaceToTheOther) {
  test::ManualClock clock;
  const Transition way({0, 2}, {1, 0}, {4, 5, false}, clock.now());
  EXPECT_EQ(way.at(clock.now()), (Face{0, 2}));
  EXPECT_EQ(way.next_frame_at(clock.now()), clock.now() + Milliseconds(5));
  clock.advance(Milliseconds(4));
  EXPECT_EQ(way.at(clock.now()), (Face{0, 2}));
  clock.advance(Milliseconds(1));
  EXPECT_EQ(way.at(clock.now()), (Face{0.25F, 1.5F}));
  clock.advance(Milliseconds(14));
  EXPECT_FALSE(way.over(clock.now()));
  clock.advance(Milliseconds(1));
  EXPECT_TRUE(way.over(clock.now()));
  EXPECT_EQ(way.at(clock.now()), (Face{1, 0}));
  EXPECT_EQ(way.next_frame_at(clock.now()), std::nullopt);
}

TEST(Transition, CosineBeginsSlowlyAndMeetsInTheMiddle) {
  test::ManualClock clock;
  const Transition way({0}, {1}, {50, 5, true}, clock.now());
  clock.advance(Milliseconds(25));
  EXPECT_LT(way.at(clock.now())[0], 0.1F);
  clock.advance(Milliseconds(100));
  EXPECT_FLOAT_EQ(way.at(clock.now())[0], 0.5F);
  clock.advance(std::chrono::hours(1));
  EXPECT_EQ(way.at(clock.now())[0], 1.0F);
}

TEST(Transition, StaysAtItsStartBeforeItBegins) {
  test::ManualClock clock;
  const Transition way({0.5F}, {1}, {}, clock.now() + Milliseconds(100));
  EXPECT_EQ(way.at(clock.now())[0], 0.5F);
  EXPECT_FALSE(way.over(clock.now()));
}

TEST(Transition, SettingsBelowOneCountAsOne) {
  test::ManualClock clock;
  const Transition way({0}, {1}, {0, 0, false}, clock.now());
  EXPECT_FALSE(way.over(clock.now()));
  EXPECT_TRUE(way.over(clock.now() + Milliseconds(1)));
}

}  // namespace
}  // namespace aucast::gui
