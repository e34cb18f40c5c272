#include "client/app/window/recording/session_video.h"

#include <gtest/gtest.h>

namespace aucast::app {
namespace {

TEST(SessionVideo, HasItsPicturesAtEqualDistancesHoweverTheScreenDraws) {
  EXPECT_EQ(pictures_due(Milliseconds(0), 25, 0), 1U);
  EXPECT_EQ(pictures_due(Milliseconds(39), 25, 1), 0U);
  EXPECT_EQ(pictures_due(Milliseconds(40), 25, 1), 1U);
  EXPECT_EQ(pictures_due(Milliseconds(1000), 25, 2), 24U);
  EXPECT_EQ(pictures_due(Milliseconds(1000), 25, 26), 0U);
  EXPECT_EQ(pictures_due(Milliseconds(-5), 25, 0), 0U);
}

}  // namespace
}  // namespace aucast::app
