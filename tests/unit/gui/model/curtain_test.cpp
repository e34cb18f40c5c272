#include "client/gui/model/curtain.h"

#include <gtest/gtest.h>

namespace aucast::gui {
namespace {

Instant at(int ms) {
  return Instant{} + Milliseconds(ms);
}

TEST(Curtain, StaysUpInAWindow) {
  Curtain curtain;
  EXPECT_FALSE(curtain.hides(at(60'000)));
  EXPECT_EQ(curtain.falls_at(at(0)), std::nullopt);
}

TEST(Curtain, FallsInFullScreenWhenTheMouseIsStill) {
  Curtain curtain;
  curtain.set_full_screen(true, at(1000));
  EXPECT_FALSE(curtain.hides(at(3999)));
  EXPECT_EQ(curtain.falls_at(at(1000)), at(4000));
  EXPECT_TRUE(curtain.hides(at(4000)));
  EXPECT_EQ(curtain.falls_at(at(4000)), std::nullopt);
}

TEST(Curtain, ComesUpWithTheMouseAndOutsideOfFullScreen) {
  Curtain curtain;
  curtain.set_full_screen(true, at(0));
  ASSERT_TRUE(curtain.hides(at(3000)));
  curtain.touched(at(5000));
  EXPECT_FALSE(curtain.hides(at(7999)));
  EXPECT_TRUE(curtain.hides(at(8000)));
  curtain.set_full_screen(false, at(9000));
  EXPECT_FALSE(curtain.hides(at(60'000)));
}

}  // namespace
}  // namespace aucast::gui
