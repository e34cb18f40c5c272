#include "common/link/loop_gate.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace aucast::link {
namespace {

class LoopGateTest : public ::testing::Test {
 protected:
  void post(const std::string& word, std::size_t bytes = 0) {
    gate->post([this, word] { done += word + ' '; }, bytes);
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
  post("all", LoopGate::kBytesMax);
  EXPECT_EQ(gate->left_out(), 0U);
  post("more", 1);
  post("more", 1);
  post("nothing");
  EXPECT_EQ(gate->left_out(), 2U);
  EXPECT_EQ(run(), "all full nothing ");
  post("room", LoopGate::kBytesMax);
  post("more", 1);
  EXPECT_EQ(run(), "room ") << "what was carried out made room";
  EXPECT_EQ(gate->left_out(), 3U);
}

TEST_F(LoopGateTest, CarriesOutNothingOnceItIsClosed) {
  post("before");
  gate->close();
  post("after");
  EXPECT_EQ(run(), "");
  EXPECT_FALSE(gate->is_open());
}

}  // namespace
}  // namespace aucast::link
