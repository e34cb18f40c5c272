#include "tests/support/linkemu/link_queue.h"

#include <gtest/gtest.h>

namespace aucast::linkemu {
namespace {

using namespace std::chrono_literals;

const Instant kBegin = Instant{} + 1h;

TEST(LinkQueue, DelaysByTheRateAndTheDelay) {
  LinkQueue link({.delay_ms = 300, .kilobits = 64}, 1);
  link.put(std::string(80, 'a'), kBegin);  // 10 ms at 64 kbit/s
  link.put(std::string(80, 'b'), kBegin);
  EXPECT_EQ(link.next_at(), kBegin + 310ms);
  EXPECT_FALSE(link.take(kBegin + 309ms).has_value());
  EXPECT_EQ(link.take(kBegin + 310ms), std::string(80, 'a'));
  EXPECT_FALSE(link.take(kBegin + 319ms).has_value());
  EXPECT_EQ(link.take(kBegin + 320ms), std::string(80, 'b'));
  EXPECT_FALSE(link.next_at().has_value());
}

TEST(LinkQueue, KeepsTheOrderWhateverTheJitter) {
  LinkQueue link({.delay_ms = 100, .jitter_ms = 90}, 1);
  for (int n = 0; n < 1000; ++n) link.put(std::to_string(n), kBegin + n * 1ms);
  for (int n = 0; n < 1000; ++n) {
    const Instant due = *link.next_at();
    EXPECT_GE(due, kBegin + n * 1ms + 10ms);
    EXPECT_EQ(link.take(due), std::to_string(n));
  }
}

TEST(LinkQueue, LosesSoManyInBurstsOfSuchALength) {
  LinkQueue link({.loss_percent = 10, .burst = 5}, 1);
  constexpr int kPackets = 200'000;
  int bursts = 0;
  std::uint64_t lost = 0;
  bool before = false;
  for (int n = 0; n < kPackets; ++n) {
    link.put("x", kBegin);
    const bool now_lost = link.lost() > lost;
    if (now_lost && !before) ++bursts;
    before = now_lost;
    lost = link.lost();
    static_cast<void>(link.take(kBegin));
  }
  EXPECT_NEAR(static_cast<double>(lost) / kPackets, 0.1, 0.01);
  EXPECT_NEAR(static_cast<double>(lost) / bursts, 5, 0.5);
  EXPECT_GT(link.longest_loss(), 20U);
  EXPECT_LT(link.longest_loss(), 100U);
}

TEST(LinkQueue, LosesWhatItsQueueCannotHoldAndWhatComesWhileItIsDown) {
  LinkQueue link({.kilobits = 8, .queue_bytes = 100}, 1);
  for (int n = 0; n < 5; ++n) link.put(std::string(40, 'x'), kBegin);
  EXPECT_EQ(link.too_many(), 3U);
  link.set_down(true);
  link.put("x", kBegin);
  EXPECT_EQ(link.lost(), 3U) << "two were on their way";
  EXPECT_FALSE(link.next_at().has_value());
  link.set_down(false);
  link.put("x", kBegin + 1s);
  EXPECT_TRUE(link.take(kBegin + 2s).has_value());
  EXPECT_EQ(link.passed(), 1U);
}

}  // namespace
}  // namespace aucast::linkemu
