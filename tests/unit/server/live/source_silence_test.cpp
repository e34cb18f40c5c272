#include "server/live/source_silence.h"

#include <gtest/gtest.h>

#include "common/sources/hold.h"
#include "tests/support/steady_time.h"

namespace aucast::server {
namespace {

using namespace std::chrono_literals;

constexpr SteadyTime kSince = test::at_second(100);
constexpr SteadyTime kHeld = kSince + Seconds(sources::kHoldSeconds);
constexpr SteadyTime kNeutral = kHeld + Seconds(sources::kEaseSeconds);

TEST(SourceSilence, BeforeTheFirstKeyframeNothingIsSaid) {
  SourceSilence silence(Milliseconds(60'000));
  EXPECT_FALSE(silence.to_be_said(kSince, kHeld + 1s));
  EXPECT_TRUE(silence.broken()) << "the first is there";
  EXPECT_FALSE(silence.broken()) << "there was no silence";
}

TEST(SourceSilence, IsSaidOnceWhenTheFaceIsNoLongerHeld) {
  SourceSilence silence(Milliseconds(60'000));
  EXPECT_TRUE(silence.broken());
  EXPECT_EQ(silence.next(kSince, false), kHeld);
  EXPECT_FALSE(silence.to_be_said(kSince, kHeld - 0.01s));
  EXPECT_TRUE(silence.to_be_said(kSince, kHeld));
  EXPECT_FALSE(silence.to_be_said(kSince, kHeld + 1s));
  EXPECT_TRUE(silence.broken());
  EXPECT_TRUE(silence.to_be_said(kSince + 50s, kHeld + 50s)) << "another one";
}

TEST(SourceSilence, EndsTheStreamAfterTheTimeOut) {
  SourceSilence silence(Milliseconds(60'000));
  EXPECT_EQ(silence.patience(), 60s);
  EXPECT_FALSE(silence.is_over(kSince, kSince + 59.9s));
  EXPECT_TRUE(silence.is_over(kSince, kSince + 60s));
  EXPECT_EQ(silence.next(kSince, false), kSince + 60s);
  EXPECT_EQ(silence.next(kSince, true), std::nullopt);
}

TEST(SourceSilence, WithoutATimeOutItNeverEndsTheStream) {
  SourceSilence silence(Milliseconds(0));
  silence.set_final(true);
  EXPECT_FALSE(silence.ends());
  EXPECT_FALSE(silence.is_over(kSince, kSince + 1e6s));
  EXPECT_EQ(silence.next(kSince, false), std::nullopt);
}

TEST(SourceSilence, WhereNothingCanComeItEndsWithTheNeutralFace) {
  SourceSilence silence(Milliseconds(60'000));
  silence.set_final(true);
  EXPECT_FALSE(silence.is_over(kSince, kNeutral - 0.01s));
  EXPECT_TRUE(silence.is_over(kSince, kNeutral + 0.01s));
  SourceSilence hasty(Milliseconds(1));
  hasty.set_final(true);
  EXPECT_TRUE(hasty.is_over(kSince, kSince + 0.01s)) << "a shorter time-out counts";
  silence.set_final(false);
  EXPECT_FALSE(silence.is_over(kSince, kNeutral + 0.01s)) << "a writer is back";
}

}  // namespace
}  // namespace aucast::server
