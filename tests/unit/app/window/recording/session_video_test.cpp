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

TEST(VideoTime, OfALongStallTenSecondsAreLeft) {
  const Instant begin = Instant{} + Milliseconds(5000);
  VideoTime time(begin);
  EXPECT_EQ(time.place_of(begin + Milliseconds(10'000)), Milliseconds(10'000));
  const Instant woken = begin + Milliseconds(3'610'000);
  EXPECT_EQ(time.place_of(woken), Milliseconds(20'000));
  EXPECT_EQ(time.place_of(woken + Milliseconds(40)), Milliseconds(20'040)) << "from then on";
  EXPECT_EQ(time.place_of(woken - Milliseconds(100)), Milliseconds(19'900)) << "looked back at";
}

}  // namespace
}  // namespace aucast::app
