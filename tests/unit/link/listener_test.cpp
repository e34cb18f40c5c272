#include "common/link/listener.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace aucast::link {
namespace {

using asio::ip::tcp;

constexpr AcceptLimits kAcceptLimits{16, Milliseconds(200)};

TEST(Listener, LetsOthersHaveTheirTurnWhenManyKnock) {
  asio::io_context io;
  Listener listener(io, kAcceptLimits);
  ASSERT_TRUE(listener.open("127.0.0.1", 0));
  std::vector<tcp::socket> knocking;
  for (int n = 0; n < 3 * kAcceptLimits.in_a_row; ++n) {
    knocking.emplace_back(io).connect(listener.endpoint());
  }
  int taken = 0;
  listener.start([&taken](tcp::socket, const tcp::endpoint&) { ++taken; });
  ASSERT_EQ(io.run_one(), 1U);
  EXPECT_EQ(taken, kAcceptLimits.in_a_row);
  while (taken < 3 * kAcceptLimits.in_a_row) ASSERT_EQ(io.run_one(), 1U);
  listener.stop();
  io.run();
  EXPECT_EQ(taken, 3 * kAcceptLimits.in_a_row);
}

TEST(Listener, MayBeStoppedByWhomItTells) {
  asio::io_context io;
  Listener listener(io, kAcceptLimits);
  ASSERT_TRUE(listener.open("127.0.0.1", 0));
  std::vector<tcp::socket> knocking;
  for (int n = 0; n < 3; ++n) knocking.emplace_back(io).connect(listener.endpoint());
  int taken = 0;
  listener.start([&](tcp::socket, const tcp::endpoint&) {
    ++taken;
    listener.stop();
  });
  io.run();
  EXPECT_EQ(taken, 1);
  EXPECT_EQ(listener.failures(), 0U);
}

TEST(Listener, MayGoWhileItWaits) {
  asio::io_context io;
  auto listener = std::make_unique<Listener>(io, kAcceptLimits);
  ASSERT_TRUE(listener->open("127.0.0.1", 0));
  int taken = 0;
  listener->start([&taken](tcp::socket, const tcp::endpoint&) { ++taken; });
  listener.reset();
  io.run();
  EXPECT_EQ(taken, 0);
}

TEST(Listener, AddressesThatTakeEachOthersConnectionsOverlap) {
  EXPECT_TRUE(overlap("127.0.0.1", "127.0.0.1"));
  EXPECT_TRUE(overlap("127.0.0.1", "localhost"));
  EXPECT_TRUE(overlap("0.0.0.0", "127.0.0.1"));
  EXPECT_TRUE(overlap("127.0.0.1", "[::]"));
  EXPECT_TRUE(overlap("::", "0.0.0.0"));
  EXPECT_TRUE(overlap("[::1]", "::1"));
  EXPECT_TRUE(overlap("au.example", "au.example"));
  EXPECT_FALSE(overlap("127.0.0.1", "127.0.0.2"));
  EXPECT_FALSE(overlap("0.0.0.0", "::1"));
  EXPECT_FALSE(overlap("au.example", "127.0.0.1"));
}

TEST(Listener, LocalhostIsTheLoopbackWhateverAResolverSays) {
  asio::io_context io;
  Listener listener(io, kAcceptLimits);
  ASSERT_TRUE(listener.open("au.localhost", 0));
  EXPECT_TRUE(listener.endpoint().address().is_loopback());
}

}  // namespace
}  // namespace aucast::link
