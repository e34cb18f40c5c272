#include "protocol/live_feed.h"

#include <gtest/gtest.h>

namespace aucast::protocol {
namespace {

Keyframe keyframe(std::uint8_t percent, std::uint32_t ms = 33) {
  Keyframe made;
  made.terms = {{12, Side::Both, percent}, {25, Side::Both, 70}, {51, Side::Both, 9}};
  made.time_ms = ms;
  return made;
}

TEST(LiveFeed, HoldsTheNewestKeyframeInEveryForm) {
  LiveFeed feed(250, 20);
  EXPECT_EQ(feed.newest(), nullptr);
  EXPECT_TRUE(feed.latest().empty());
  feed.add(keyframe(50));
  ASSERT_NE(feed.newest(), nullptr);
  EXPECT_EQ(feed.newest()->number, 0U);
  EXPECT_EQ(feed.newest()->classic, "{12,25}");
  EXPECT_EQ(feed.newest()->full, "{12:50,25:70,51:9;33}");
  EXPECT_EQ(feed.newest()->changes, feed.newest()->full);
  feed.add(keyframe(60));
  EXPECT_EQ(feed.newest()->number, 1U);
  EXPECT_EQ(feed.newest()->full, "{12:60,25:70,51:9;33}");
  EXPECT_EQ(feed.newest()->changes, "{~12:60;33}");
  EXPECT_EQ(feed.latest().size(), 1U);
}

TEST(LiveFeed, OfMomentsThatComeTogetherTheNewestAreKept) {
  LiveFeed feed(250, 20);
  feed.begin_moments();
  for (std::size_t i = 0; i < LiveFeed::kLatestMax; ++i) feed.add(keyframe(50));
  EXPECT_EQ(feed.latest().front().number, 0U);
  feed.add(keyframe(50));
  EXPECT_EQ(feed.latest().size(), LiveFeed::kLatestMax);
  EXPECT_EQ(feed.latest().front().number, 1U);
  EXPECT_EQ(feed.newest()->number, LiveFeed::kLatestMax);
}

TEST(LiveFeed, AFullKeyframeComesEveryTenSeconds) {
  LiveFeed feed(250, 20);
  std::size_t since_full = 0;
  for (int i = 0; i < 1000; ++i) {
    feed.add(keyframe(static_cast<std::uint8_t>(1 + i % 90), 100));
    since_full = feed.newest()->changes == feed.newest()->full ? 0 : since_full + 1;
    EXPECT_LT(since_full, 100U);
  }
}

TEST(LiveFeed, AnEndIsTakenBackByWhatComes) {
  LiveFeed feed(250, 20);
  feed.end();
  EXPECT_TRUE(feed.ended());
  feed.add(keyframe(50));
  EXPECT_FALSE(feed.ended());
}

TEST(LiveFeed, TheWindowGoesByWhatCameLately) {
  LiveFeed feed(250, 20);
  for (int i = 0; i < 200; ++i) feed.add(keyframe(50, 100));
  EXPECT_EQ(feed.window_max(), 20U);
  for (int i = 0; i < 200; ++i) feed.add(keyframe(50, 5000));
  EXPECT_EQ(feed.window_max(), 2U);
}

TEST(LiveFeed, CaptionsFarAheadOfTheFaceCostTheOldest) {
  LiveFeed feed(250, 20, false, true);
  feed.add(keyframe(50));
  for (std::uint64_t n = 0; n < kLiveCaptionsMax; ++n) {
    feed.add_caption({1'000 + n, std::to_string(n)});
  }
  EXPECT_EQ(feed.captions().size(), kLiveCaptionsMax);
  EXPECT_EQ(feed.captions().front().text, "0");
  EXPECT_EQ(feed.captions_left_out(), 0U);
  feed.add_caption({5'000, "one more"});
  EXPECT_EQ(feed.captions().size(), kLiveCaptionsMax);
  EXPECT_EQ(feed.captions().front().text, "1");
  EXPECT_EQ(feed.captions_left_out(), 1U);
}

TEST(LiveFeed, CaptionsThatAreOverAreNotLeftOut) {
  LiveFeed feed(250, 20, false, true);
  for (std::uint64_t n = 0; n < 3 * kLiveCaptionsMax; ++n) {
    feed.add(keyframe(50, 100));
    feed.add_caption({100 * n, std::to_string(n)});
  }
  EXPECT_EQ(feed.captions().size(), 1U);
  EXPECT_EQ(feed.captions_left_out(), 0U);
}

}  // namespace
}  // namespace aucast::protocol
