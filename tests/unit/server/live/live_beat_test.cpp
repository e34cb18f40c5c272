#include "server/live/live_beat.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/raw_client.h"
#include "tests/support/run_until.h"
#include "tests/unit/protocol/packets.h"

namespace aucast::server {
namespace {

using namespace std::chrono_literals;
using protocol::KeyframeTime;

std::shared_ptr<const protocol::EncodedStream> two_moments(Milliseconds first) {
  protocol::EncodedStream stream;
  stream.classic = test::packets({"{1}", "{2}"});
  stream.negotiated = stream.classic;
  stream.times = {KeyframeTime(first.count()), KeyframeTime(3'600'000)};
  return std::make_shared<const protocol::EncodedStream>(std::move(stream));
}

/// Lets the loop run until the live stream has come to `number`.
void run_until(asio::io_context& io, const protocol::LiveChannel& live, std::uint64_t number) {
  EXPECT_TRUE(test::run_until(io, [&] { return live.newest()->number >= number; }));
  EXPECT_EQ(live.newest()->number, number);
}

TEST(LiveBeat, TellsOfWhatIsDueBeforeTheLoopGoesRound) {
  asio::io_context io;
  int told = 0;
  LiveBeat beat(io, [&told] { ++told; });
  const auto live = beat.play("a", two_moments(50ms), false);
  const auto until = std::chrono::steady_clock::now() + test::kPatience;
  while (live->newest()->number == 0 && std::chrono::steady_clock::now() < until) beat.catch_up();
  EXPECT_EQ(live->newest()->number, 1U);
  EXPECT_EQ(told, 1);
}

TEST(LiveBeat, TellsOfEachMomentOnce) {
  asio::io_context io;
  int told = 0;
  LiveBeat beat(io, [&told] { ++told; });
  const auto live = beat.play("a", two_moments(1ms), false);
  run_until(io, *live, 1);
  for (int n = 0; n < 3; ++n) {
    beat.catch_up();
    io.poll();
  }
  EXPECT_EQ(told, 1);
}

TEST(LiveBeat, HasNothingToCatchUpWithWithoutStreams) {
  asio::io_context io;
  LiveBeat beat(io, [] {});
  beat.catch_up();
  EXPECT_EQ(io.poll(), 0U);
}

TEST(LiveBeat, IsSilentWhenItHasStopped) {
  asio::io_context io;
  int told = 0;
  LiveBeat beat(io, [&told] { ++told; });
  const auto live = beat.play("a", two_moments(1ms), false);
  beat.stop();
  const auto until = std::chrono::steady_clock::now() + 5ms;
  while (std::chrono::steady_clock::now() < until) beat.catch_up();
  io.run();
  EXPECT_EQ(told, 0);
}

TEST(LiveBeat, MayEndWhileItsHandlerIsQueued) {
  asio::io_context io;
  asio::steady_timer first(io);
  std::vector<std::string> done;
  auto beat = std::make_unique<LiveBeat>(io, [&done] { done.emplace_back("beat"); });
  const auto live = beat->play("a", two_moments(1ms), false);
  first.expires_at(std::chrono::steady_clock::now() -
                   1h);  // its handler is queued before the beat's
  first.async_wait([&](const std::error_code& /*error*/) {
    done.emplace_back("ended");
    beat.reset();
  });
  // Both are due: the loop queues both handlers at once.
  const auto until = std::chrono::steady_clock::now() + 5ms;
  while (std::chrono::steady_clock::now() < until) std::this_thread::yield();
  io.run();
  EXPECT_EQ(done, std::vector<std::string>{"ended"});
}

TEST(LiveBeat, AStreamReadAgainGoesOnWhereItIs) {
  asio::io_context io;
  LiveBeat beat(io, [] {});
  const auto first = beat.play("a", two_moments(1h), false);
  EXPECT_EQ(beat.play("a", two_moments(1h), false), first);
  EXPECT_NE(beat.play("b", two_moments(1h), false), first) << "another name";
  EXPECT_NE(beat.play("a", two_moments(30min), false), first) << "other content";
}

TEST(LiveBeat, AStreamThatNobodyHoldsIsForgotten) {
  asio::io_context io;
  LiveBeat beat(io, [] {});
  const std::weak_ptr<const protocol::LiveChannel> gone = beat.play("a", two_moments(1ms), false);
  EXPECT_TRUE(gone.expired());
  const auto held = beat.play("b", two_moments(1ms), false);
  run_until(io, *held, 1);
}

}  // namespace
}  // namespace aucast::server
