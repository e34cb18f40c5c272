#include "server/serve/departure.h"

#include <gtest/gtest.h>

namespace aucast::server {
namespace {

using namespace std::chrono_literals;

TEST(Departure, IsEvenlySpread) {
  EXPECT_EQ(gone_by(300, 0s, 10s), 0U);
  EXPECT_EQ(gone_by(300, 1s, 10s), 30U);
  EXPECT_EQ(gone_by(300, 9999ms, 10s), 299U);
  EXPECT_EQ(gone_by(300, 10s, 10s), 300U);
  EXPECT_EQ(gone_by(300, 1h, 10s), 300U);
  EXPECT_EQ(gone_by(1, 5s, 10s), 0U);
  EXPECT_EQ(gone_by(0, 5s, 10s), 0U);
}

TEST(Departure, SendsEverybodyAwayAndSaysWhenItIsOver) {
  asio::io_context io;
  std::size_t gone = 0;
  std::size_t times = 0;
  bool over = false;
  Departure departure(
      io,
      [&](std::size_t count) {
        gone += count;
        ++times;
      },
      [&] { over = true; });
  departure.begin(50, 100ms);
  EXPECT_LT(gone, 50U) << "not all at once";
  io.run();
  EXPECT_EQ(gone, 50U);
  EXPECT_GE(times, 1U);
  EXPECT_TRUE(over);
}

TEST(Departure, CanBeStopped) {
  asio::io_context io;
  std::size_t gone = 0;
  bool over = false;
  Departure departure(
      io, [&](std::size_t count) { gone += count; }, [&] { over = true; });
  departure.begin(50, 1h);
  departure.stop();
  io.run();
  EXPECT_FALSE(over);
  EXPECT_LT(gone, 50U);
}

}  // namespace
}  // namespace aucast::server
