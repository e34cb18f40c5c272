#include "protocol/live_feed.h"

#include <gtest/gtest.h>

namespace aucast::protocol {
namespace {

Keyframe keyframe(std::uint8_t percent, std::uint32_t ms = 33) {
  Keyframe made;
  made.terms = {{12, Side::Both, percent}, {25, Side::Both, 70}, {51, Side::Both, 9}};
  made.duration_ms = ms;
  return made;
}

TEST(LiveFeed, TheStreamHoldsTheNewestKeyframeOncePerLevel) {
  const auto held = std::make_shared<ServedStream>();
  const ServedStream& stream = *held;
  LiveFeed feed(250, 20);
  feed.attach(held);
  EXPECT_EQ(stream.clock, &feed);
  EXPECT_FALSE(feed.newest().has_value());
  feed.add(keyframe(50));
  EXPECT_EQ(feed.newest(), (LiveMoment{0, 0}));
  EXPECT_EQ(stream.classic, std::vector<std::string>{"{12,25}"});
  EXPECT_EQ(stream.negotiated, std::vector<std::string>{"{12:50,25:70,51:9;33}"});
  EXPECT_EQ(stream.changes, stream.negotiated);
  feed.add(keyframe(60));
  EXPECT_EQ(feed.newest(), (LiveMoment{1, 0}));
  EXPECT_EQ(stream.negotiated, std::vector<std::string>{"{12:60,25:70,51:9;33}"});
  EXPECT_EQ(stream.changes, std::vector<std::string>{"{~12:60;33}"});
}

TEST(LiveFeed, AFullKeyframeComesEveryTenSeconds) {
  const auto held = std::make_shared<ServedStream>();
  const ServedStream& stream = *held;
  LiveFeed feed(250, 20);
  feed.attach(held);
  std::size_t since_full = 0;
  for (int i = 0; i < 1000; ++i) {
    feed.add(keyframe(static_cast<std::uint8_t>(1 + i % 90), 100));
    since_full = stream.changes.front() == stream.negotiated.front() ? 0 : since_full + 1;
    EXPECT_LT(since_full, 100U);
  }
}

TEST(LiveFeed, StreamsThatCameLaterAreFedToo) {
  LiveFeed feed(250, 20);
  feed.add(keyframe(50));
  const auto later = std::make_shared<ServedStream>();
  feed.attach(later);
  EXPECT_EQ(later->negotiated, std::vector<std::string>{"{12:50,25:70,51:9;33}"});
  {
    const auto gone = std::make_shared<ServedStream>();
    feed.attach(gone);
  }
  feed.add(keyframe(60));
  EXPECT_EQ(later->changes, std::vector<std::string>{"{~12:60;33}"});
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
  EXPECT_EQ(feed.moments_in(Milliseconds(2000)), 20U);
  EXPECT_EQ(feed.moments_in(Milliseconds(1)), 1U);
}

}  // namespace
}  // namespace aucast::protocol
