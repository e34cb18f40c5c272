#include "client/pipeline/face_delay.h"

#include <gtest/gtest.h>

namespace aucast::pipeline {
namespace {

const Instant kBegin{std::chrono::hours(1)};

TEST(FaceDelay, GivesTheFaceOfAMoment) {
  FaceDelay delay;
  EXPECT_TRUE(delay.empty());
  for (int i = 0; i <= 10; ++i) {
    delay.add(kBegin + Milliseconds(10 * i), {static_cast<float>(i), 1});
  }
  EXPECT_EQ(delay.at(kBegin - Milliseconds(5)).front(), 0);
  EXPECT_EQ(delay.at(kBegin + Milliseconds(20)).front(), 2);
  EXPECT_FLOAT_EQ(delay.at(kBegin + Milliseconds(25)).front(), 2.5F);
  EXPECT_EQ(delay.at(kBegin + Milliseconds(25)).back(), 1);
  EXPECT_EQ(delay.at(kBegin + Milliseconds(200)).front(), 10);
}

TEST(FaceDelay, ForgetsWhatNobodyWillAskFor) {
  FaceDelay delay;
  for (int i = 0; i <= 10; ++i) delay.add(kBegin + Milliseconds(10 * i), {static_cast<float>(i)});
  delay.forget_before(kBegin + Milliseconds(95));
  EXPECT_EQ(delay.at(kBegin).front(), 9);
  EXPECT_FLOAT_EQ(delay.at(kBegin + Milliseconds(95)).front(), 9.5F);
}

TEST(FaceDelay, OfTwoFacesOfOneMomentTheLaterCounts) {
  FaceDelay delay;
  delay.add(kBegin, {1});
  delay.add(kBegin, {2});
  EXPECT_EQ(delay.at(kBegin).front(), 2);
}

}  // namespace
}  // namespace aucast::pipeline
