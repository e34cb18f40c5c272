#include "server/live/live_beat.h"

#include <thread>

#include <gtest/gtest.h>

#include "tests/support/raw_client.h"

namespace aucast::server {
namespace {

using namespace std::chrono_literals;

protocol::ServerCatalogue two_moments(Milliseconds first) {
  protocol::ServedStream stream;
  stream.times = {first, 1h};
  protocol::ServerCatalogue catalogue;
  catalogue.streams.push_back(std::move(stream));
  return catalogue;
}

TEST(LiveBeat, TellsOfWhatIsDueBeforeTheLoopGoesRound) {
  asio::io_context io;
  auto catalogue = two_moments(50ms);
  LiveBeat beat(io);
  beat.start(catalogue, nullptr, [] {});
  const protocol::LiveTime& clock = *catalogue.streams.front().clock;
  const auto until = std::chrono::steady_clock::now() + test::kPatience;
  while (clock.newest()->number == 0 && std::chrono::steady_clock::now() < until) beat.catch_up();
  EXPECT_EQ(clock.newest()->number, 1U);
}

TEST(LiveBeat, TellsOfEachMomentOnce) {
  asio::io_context io;
  auto catalogue = two_moments(1h);
  int told = 0;
  LiveBeat beat(io);
  beat.start(catalogue, nullptr, [&told] { ++told; });
  for (int n = 0; n < 3; ++n) {
    beat.catch_up();
    io.poll();
  }
  EXPECT_EQ(told, 1);
}

TEST(LiveBeat, HasNothingToCatchUpWithWithoutClocks) {
  asio::io_context io;
  LiveBeat beat(io);
  beat.catch_up();
  EXPECT_EQ(io.poll(), 0U);
}

TEST(LiveBeat, IsSilentWhenItHasStopped) {
  asio::io_context io;
  auto catalogue = two_moments(20ms);
  int told = 0;
  LiveBeat beat(io);
  beat.start(catalogue, nullptr, [&told] { ++told; });
  beat.stop();
  std::this_thread::sleep_for(30ms);
  beat.catch_up();
  io.run();
  EXPECT_EQ(told, 1);
}

}  // namespace
}  // namespace aucast::server
