#include "server/serve/listener.h"

#include <gtest/gtest.h>

#include "protocol/limits.h"

namespace aucast::server {
namespace {

using asio::ip::tcp;

TEST(Listener, LetsOthersHaveTheirTurnWhenManyKnock) {
  asio::io_context io;
  Listener listener(io);
  ASSERT_TRUE(listener.open("127.0.0.1", 0));
  std::vector<tcp::socket> knocking;
  for (int n = 0; n < 3 * protocol::kAcceptsInARow; ++n) {
    knocking.emplace_back(io).connect(listener.endpoint());
  }
  int taken = 0;
  listener.start([&taken](tcp::socket, const tcp::endpoint&) { ++taken; });
  ASSERT_EQ(io.run_one(), 1U);
  EXPECT_EQ(taken, protocol::kAcceptsInARow);
  while (taken < 3 * protocol::kAcceptsInARow) ASSERT_EQ(io.run_one(), 1U);
  listener.stop();
  io.run();
  EXPECT_EQ(taken, 3 * protocol::kAcceptsInARow);
}

TEST(Listener, LocalhostIsTheLoopbackWhateverAResolverSays) {
  asio::io_context io;
  Listener listener(io);
  ASSERT_TRUE(listener.open("au.localhost", 0));
  EXPECT_TRUE(listener.endpoint().address().is_loopback());
}

}  // namespace
}  // namespace aucast::server
