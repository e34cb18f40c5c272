// A crowd of good clients, each of which must get its stream byte for byte, while hostile peers
// break off at every step of the protocol, dribble, flood and knock a thousand times a second.
#include <algorithm>
#include <atomic>
#include <functional>
#include <thread>

#include <gtest/gtest.h>

#include "tests/integration/server_running.h"
#include "tests/support/seeded.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

using namespace std::chrono_literals;

constexpr int kPackets = 60;
constexpr std::size_t kGoodClients = 200;

/// The good clients' own stream; what it is on the wire for level 2.
std::string stream_text(std::string& wire) {
  std::string text = "Beg_Stream\n";
  for (int n = 0; n < kPackets; ++n) {
    const std::string set =
        "1:" + std::to_string(10 + n) + ",L12:" + std::to_string(90 - n) + ";40";
    text += set + '\n';
    wire += '{' + set + '}';
  }
  return text + "End_Stream\n";
}

class ServerCrowd : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string file = folder_.write("exact.txt", stream_text(wire_));
    // Nobody reads the log here until the end: thousands of lines would fill the pipe.
    server_.emplace(
        std::vector<std::string>{"--client-timeout", "30", "--log-level", "error", file});
    good_.reserve(kGoodClients);
    for (std::size_t n = 0; n < kGoodClients; ++n) {
      std::string hello;
      good_.push_back(say_hello(*server_, "{hello v=2 window=2}", hello));
      ASSERT_EQ(hello, "{hello v=2 window=2 stream=exact duration=2400 keyframe=250}");
    }
    got_.resize(kGoodClients);
  }

  /// The crowd answers packet by packet, all together, and calls `between` after each round.
  void play(const std::function<void(int round)>& between) {
    const std::size_t packet = wire_.size() / kPackets;
    for (int round = 0; round < kPackets; ++round) {
      for (std::size_t n = 0; n < kGoodClients; ++n) {
        got_[n] += good_[n].receive_until("}");
        ASSERT_EQ(got_[n].size(), packet * static_cast<std::size_t>(round + 1)) << n;
        ASSERT_TRUE(good_[n].send("1"));
      }
      between(round);
    }
    for (std::size_t n = 0; n < kGoodClients; ++n) {
      ASSERT_EQ(got_[n], wire_) << n;
      ASSERT_EQ(good_[n].receive_all(), kEnd) << n;
      ASSERT_FALSE(good_[n].broken()) << n;
      good_[n].end_sending();
    }
    EXPECT_EQ(server_->terminate(), 0);
  }

  const TempFolder folder_;
  std::string wire_;
  std::optional<RunningTransmitter> server_;
  std::vector<RawClient> good_;
  std::vector<std::string> got_;
};

TEST_F(ServerCrowd, SeesNothingOfResetsAtEveryStep) {
  // Each says this much of a conversation and is gone; the next one a byte more.
  const std::string whole = "{hello v=2 window=2 stream=exact}1-1-31-31-4";
  play([&](int round) {
    for (std::size_t more : {0U, 20U}) {
      const auto step = static_cast<std::size_t>(round) + more;
      RawClient mean = server_->connect();
      mean.send(whole.substr(0, std::min(step, whole.size())));
      if (step > 20) static_cast<void>(mean.receive(1, 100ms));
      mean.reset();
    }
    RawClient classic = server_->connect();
    classic.send(std::string(static_cast<std::size_t>(round), '1'));
    if (round % 2 == 0) static_cast<void>(classic.receive(static_cast<std::size_t>(round)));
    classic.reset();
  });
}

TEST_F(ServerCrowd, SeesNothingOfThoseWhoDribble) {
  std::vector<RawClient> slow;
  for (int n = 0; n < 100; ++n) slow.push_back(server_->connect());
  const std::string hello = "{hello v=2 window=256 stream=exact}";
  play([&](int round) {
    const auto at = static_cast<std::size_t>(round);
    for (std::size_t n = 0; n < slow.size(); ++n) {
      // A third spells a hello, a third blanks, a third answers what it has not read.
      slow[n].send(n % 3 == 0 ? hello.substr(at % hello.size(), 1) : n % 3 == 1 ? " " : "1");
    }
  });
}

TEST_F(ServerCrowd, SeesNothingOfFloodsAndRandomBytes) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  std::vector<RawClient> floods;
  play([&](int round) {
    RawClient flood = server_->connect();
    std::string bytes(static_cast<std::size_t>(seeded.integer(1, 60000)), '1');
    for (char& byte : bytes) {
      if (round % 3 == 1) byte = static_cast<char>(seeded.integer(0, 255));
      if (round % 3 == 2) byte = "-1-3"[seeded.integer(0, 3)];
    }
    flood.send(bytes, 50ms);
    floods.push_back(std::move(flood));
  });
}

TEST_F(ServerCrowd, SeesNothingOfAThousandKnocks) {
  std::atomic<bool> stop{false};
  std::atomic<int> knocks{0};
  std::jthread knocking([&] {
    while (!stop) {
      RawClient knock = server_->connect();
      if (++knocks % 2 == 0) knock.reset();
    }
  });
  play([](int) {});
  stop = true;
  knocking.join();
  // So many in the time of one playback; how many a second is the machine's affair.
  EXPECT_GT(knocks, 100);
}

}  // namespace
}  // namespace aucast::test
