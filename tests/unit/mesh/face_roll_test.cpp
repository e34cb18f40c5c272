#include "common/mesh/face_roll.h"

#include <gtest/gtest.h>

namespace aucast::mesh {
namespace {

Square at(double x, double y = 100, double side = 80) {
  return {x, y, side, 0};
}

TEST(FaceRoll, FacesCountAsTheyAreFirstSeen) {
  FaceRoll roll;
  EXPECT_FALSE(roll.follows_any());
  EXPECT_EQ(roll.number_of(at(100)), 0U);
  EXPECT_TRUE(roll.seen(0, at(100)));
  EXPECT_EQ(roll.number_of(at(300)), 1U);
  EXPECT_TRUE(roll.seen(1, at(300)));
  EXPECT_EQ(roll.size(), 2U);
  EXPECT_EQ(roll.where(1)->x, 300);
  EXPECT_TRUE(roll.follows_any());
}

TEST(FaceRoll, AFaceThatIsFollowedIsNotFoundOnceMore) {
  FaceRoll roll;
  EXPECT_TRUE(roll.seen(0, at(100)));
  EXPECT_FALSE(roll.number_of(at(120)));
  EXPECT_EQ(roll.number_of(at(140)), 1U) << "half a square beside it is somebody else";
}

TEST(FaceRoll, WhoWasLostIsTheSameWhenBackAtItsPlaceAndNewElsewhere) {
  FaceRoll roll;
  EXPECT_TRUE(roll.seen(0, at(100)));
  EXPECT_TRUE(roll.seen(1, at(300)));
  roll.lost(0);
  EXPECT_FALSE(roll.where(0));
  EXPECT_EQ(roll.number_of(at(110)), 0U);
  EXPECT_EQ(roll.number_of(at(500)), 2U);
  roll.lost(1);
  EXPECT_FALSE(roll.follows_any());
}

TEST(FaceRoll, TwoThatBecomeOneAreOne) {
  FaceRoll roll;
  EXPECT_TRUE(roll.seen(0, at(100)));
  EXPECT_TRUE(roll.seen(1, at(200)));
  EXPECT_FALSE(roll.seen(1, at(110))) << "it slid onto the first one's face";
  EXPECT_FALSE(roll.where(1));
  EXPECT_EQ(roll.where(0)->x, 100);
}

TEST(FaceRoll, HasNoMoreThanItsLimit) {
  FaceRoll roll;
  for (std::size_t i = 0; i < FaceRoll::kFacesMax; ++i) {
    EXPECT_TRUE(roll.seen(i, at(200.0 * static_cast<double>(i))));
  }
  EXPECT_FALSE(roll.number_of(at(-500)));
  roll.lost(3);
  EXPECT_EQ(roll.number_of(at(610)), 3U) << "a lost one may come back";
  EXPECT_FALSE(roll.number_of(at(-500)));
}

TEST(Square, ShowsTheSameAsOneAroundTheSameFace) {
  EXPECT_TRUE(show_the_same(at(100), at(120, 110, 100)));
  EXPECT_FALSE(show_the_same(at(100), at(110, 100, 20)))
      << "a small face before a large one is another";
}

}  // namespace
}  // namespace aucast::mesh
