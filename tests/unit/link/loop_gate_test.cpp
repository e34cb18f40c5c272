#include "common/link/loop_gate.h"

#include <atomic>
#include <cstddef>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include <gtest/gtest.h>
#include <asio/executor_work_guard.hpp>

#include "tests/support/run_until.h"

namespace aucast::link {
namespace {

class LoopGateTest : public ::testing::Test {
 protected:
  void post(const std::string& word) {
    gate->post([this, word] { done += word + ' '; });
  }
  void post_if_room(const std::string& word, std::size_t bytes) {
    gate->post_if_room([this, word] { done += word + ' '; }, bytes);
  }
  /// What was carried out.
  std::string run() {
    io.restart();
    io.run();
    return std::exchange(done, {});
  }

  std::string done;
  asio::io_context io;
  std::shared_ptr<LoopGate> gate = std::make_shared<LoopGate>(io, [this] { done += "full "; });
};

TEST_F(LoopGateTest, CarriesOutInTheLoopAndInOrder) {
  post("one");
  post("two");
  EXPECT_EQ(done, "");
  EXPECT_EQ(run(), "one two ");
}

TEST_F(LoopGateTest, LeavesOutAndCountsWhatHasNoRoomAndSaysSoOnce) {
  constexpr std::size_t kAll = LoopGate::kBytesMax - LoopGate::kBytesEach;
  post_if_room("all", kAll);
  EXPECT_EQ(gate->left_out(), 0U);
  post_if_room("more", 1);
  post_if_room("more", 1);
  post("few");
  EXPECT_EQ(gate->left_out(), 2U);
  EXPECT_EQ(run(), "all full few ");
  post_if_room("room", kAll);
  post_if_room("more", 1);
  EXPECT_EQ(run(), "room ") << "what was carried out made room";
  EXPECT_EQ(gate->left_out(), 3U);
}

TEST_F(LoopGateTest, WorksWithoutAByteHaveTheirLimitToo) {
  constexpr std::size_t kPosted = 1'000'000;
  constexpr std::size_t kFit = LoopGate::kBytesMax / LoopGate::kBytesEach;
  std::size_t carried_out = 0;
  for (std::size_t i = 0; i < kPosted; ++i) gate->post_if_room([&] { ++carried_out; }, 0);
  EXPECT_EQ(gate->left_out(), kPosted - kFit);
  EXPECT_EQ(run(), "full ");
  EXPECT_EQ(carried_out, kFit);
}

TEST_F(LoopGateTest, AThreadThatWaitsHasOneWorkInTheQueue) {
  constexpr int kPieces = 200;
  std::atomic<int> posted{0};
  int carried_out = 0;
  const auto piece = [&] { EXPECT_EQ(posted, ++carried_out) << "it goes on before this is done"; };
  const std::jthread worker([&] {
    for (int i = 0; i < kPieces; ++i) {
      ++posted;
      gate->post_and_wait(piece);
    }
  });
  const auto work = asio::make_work_guard(io);
  EXPECT_TRUE(aucast::test::run_until(io, [&] { return carried_out == kPieces; }));
}

TEST_F(LoopGateTest, NobodyWaitsAtAClosedGate) {
  const std::jthread worker([&] { gate->post_and_wait([this] { done += "never "; }); });
  gate->close();
  gate->post_and_wait([this] { done += "never "; });
  EXPECT_EQ(run(), "");
}

TEST_F(LoopGateTest, CarriesOutNothingOnceItIsClosed) {
  post("before");
  gate->close();
  post("after");
  post_if_room("after", 1);
  EXPECT_EQ(run(), "");
  EXPECT_FALSE(gate->is_open());
}

}  // namespace
}  // namespace aucast::link
