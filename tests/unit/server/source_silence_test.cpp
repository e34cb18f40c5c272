#include "server/live/source_silence.h"

#include <gtest/gtest.h>

#include "common/sources/hold.h"

namespace aucast::server {
namespace {

constexpr double kSince = 100;
constexpr double kHeld = kSince + sources::kHoldSeconds;
constexpr double kNeutral = kHeld + sources::kEaseSeconds;

TEST(SourceSilence, BeforeTheFirstKeyframeNothingIsSaid) {
  SourceSilence silence(Milliseconds(60'000));
  EXPECT_FALSE(silence.to_be_said(kSince, kHeld + 1));
  EXPECT_TRUE(silence.broken()) << "the first is there";
  EXPECT_FALSE(silence.broken()) << "there was no silence";
}

TEST(SourceSilence, IsSaidOnceWhenTheFaceIsNoLongerHeld) {
  SourceSilence silence(Milliseconds(60'000));
  EXPECT_TRUE(silence.broken());
  EXPECT_EQ(silence.next(kSince, false), kHeld);
  EXPECT_FALSE(silence.to_be_said(kSince, kHeld - 0.01));
  EXPECT_TRUE(silence.to_be_said(kSince, kHeld));
  EXPECT_FALSE(silence.to_be_said(kSince, kHeld + 1));
  EXPECT_TRUE(silence.broken());
  EXPECT_TRUE(silence.to_be_said(kSince + 50, kHeld + 50)) << "another one";
}

TEST(SourceSilence, EndsTheStreamAfterTheTimeOut) {
  SourceSilence silence(Milliseconds(60'000));
  EXPECT_EQ(silence.patience(), 60);
  EXPECT_FALSE(silence.is_over(kSince, kSince + 59.9));
  EXPECT_TRUE(silence.is_over(kSince, kSince + 60));
  EXPECT_EQ(silence.next(kSince, false), kSince + 60);
  EXPECT_EQ(silence.next(kSince, true), std::nullopt);
}

TEST(SourceSilence, WithoutATimeOutItNeverEndsTheStream) {
  SourceSilence silence(Milliseconds(0));
  silence.set_final(true);
  EXPECT_FALSE(silence.ends());
  EXPECT_FALSE(silence.is_over(kSince, kSince + 1e6));
  EXPECT_EQ(silence.next(kSince, false), std::nullopt);
}

TEST(SourceSilence, WhereNothingCanComeItEndsWithTheNeutralFace) {
  SourceSilence silence(Milliseconds(60'000));
  silence.set_final(true);
  EXPECT_FALSE(silence.is_over(kSince, kNeutral - 0.01));
  EXPECT_TRUE(silence.is_over(kSince, kNeutral + 0.01));
  SourceSilence hasty(Milliseconds(1));
  hasty.set_final(true);
  EXPECT_TRUE(hasty.is_over(kSince, kSince + 0.01)) << "a shorter time-out counts";
  silence.set_final(false);
  EXPECT_FALSE(silence.is_over(kSince, kNeutral + 0.01)) << "a writer is back";
}

}  // namespace
}  // namespace aucast::server
