#include "client/app/window/double_clicks.h"

#include <gtest/gtest.h>

namespace aucast::app {
namespace {

/// A press of a button that came between these two, in milliseconds.
render::InputEvent press(int after, int by, int button = 0) {
  render::InputEvent event{render::InputEvent::Kind::Button, button, 0, 1};
  event.after = Instant(Milliseconds(after));
  event.by = Instant(Milliseconds(by));
  return event;
}

TEST(DoubleClicks, TheSecondPressFollowsSoon) {
  DoubleClicks clicks;
  EXPECT_FALSE(clicks.follows(press(100, 100)));
  EXPECT_TRUE(clicks.follows(press(300, 300)));
  EXPECT_FALSE(clicks.follows(press(900, 900)));
}

TEST(DoubleClicks, HowLongAFrameTakesDoesNotMatter) {
  DoubleClicks clicks;
  EXPECT_FALSE(clicks.follows(press(0, 450)));
  EXPECT_TRUE(clicks.follows(press(450, 900))) << "it may have come at 451 ms";
  EXPECT_FALSE(clicks.follows(press(1'350, 1'800)));
}

TEST(DoubleClicks, EachButtonIsOnItsOwn) {
  DoubleClicks clicks;
  EXPECT_FALSE(clicks.follows(press(100, 100, 0)));
  EXPECT_FALSE(clicks.follows(press(200, 200, 1)));
  EXPECT_TRUE(clicks.follows(press(300, 300, 0)));
  EXPECT_FALSE(clicks.follows(press(310, 310, 7))) << "of which nobody knows";
}

}  // namespace
}  // namespace aucast::app
