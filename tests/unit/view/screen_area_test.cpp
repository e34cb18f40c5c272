#include "client/view/screen_area.h"

#include <array>

#include <gtest/gtest.h>

namespace aucast::view {
namespace {

// The experimenter's screen, and the subject's at its right, which is higher.
constexpr std::array kScreens{ScreenArea{0, 0, 1920, 1080}, ScreenArea{1920, -360, 2560, 1440}};

TEST(ScreenOf, IsTheOneThatShowsMostOfTheWindow) {
  EXPECT_EQ(screen_of({100, 100, 1280, 800}, kScreens), 0U);
  EXPECT_EQ(screen_of({2500, 0, 1280, 800}, kScreens), 1U);
  EXPECT_EQ(screen_of({1900, 100, 1280, 800}, kScreens), 1U) << "all but its edge";
  EXPECT_EQ(screen_of({700, 100, 1280, 800}, kScreens), 0U) << "all but the other edge";
}

TEST(ScreenOf, OfAWindowThatIsNowhereIsTheFirst) {
  EXPECT_EQ(screen_of({-5000, -5000, 100, 100}, kScreens), 0U);
  EXPECT_EQ(screen_of({0, 2000, 5000, 100}, kScreens), 0U) << "below both";
  EXPECT_EQ(screen_of({2000, 100, 0, 0}, kScreens), 0U) << "one without a size";
}

}  // namespace
}  // namespace aucast::view
