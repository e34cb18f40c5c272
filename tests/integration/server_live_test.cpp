// au-transmitter --live. A client that is never behind is the clock of these tests: nobody sleeps
// but a transmitter that is made to.
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/integration/server_running.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

using namespace std::chrono_literals;

/// 80 states of `ms` each, told apart by the percent of AU 1.
std::string numbered(int ms, const std::string& more = "") {
  std::string text = "Beg_Stream\n";
  for (int n = 20; n < 100; ++n) {
    text += "1:" + std::to_string(n) + more + ";" + std::to_string(ms) + "\n";
  }
  return text + "End_Stream\n";
}

class ServerLive : public ::testing::Test {
 protected:
  static std::vector<std::string> arguments(const std::string& file,
                                            std::vector<std::string> more) {
    more.insert(more.begin(), {"--live", file});
    return more;
  }

  const TempFolder folder_;
  std::string file_ = folder_.write("numbered.txt", numbered(25));
};

TEST_F(ServerLive, EverybodySeesTheSameMomentAndWhoComesLateJoinsNow) {
  RunningTransmitter server(arguments(file_, {"--loop"}));
  std::string hello;
  RawClient early = say_hello(server, "{hello v=2 window=0}", hello);
  EXPECT_EQ(hello, "{hello v=2 window=0 stream=numbered live=1 keyframe=250}");
  std::string seen;
  for (int i = 0; i < 10; ++i) ASSERT_NE(seen = early.receive_until("}"), "");
  RawClient late = say_hello(server, "{hello v=2 window=0 delta=1}", hello);
  EXPECT_EQ(hello, "{hello v=2 window=0 delta=1 stream=numbered live=1 keyframe=250}");
  const std::string first = late.receive_until("}");
  EXPECT_TRUE(first.starts_with("{1:")) << first << " is full";
  for (int i = 0; i < 80 && seen != first; ++i) seen = early.receive_until("}");
  EXPECT_EQ(seen, first);
  for (int i = 0; i < 10; ++i) EXPECT_NE(late.receive_until("}"), "");
  server.process().signal(SIGTERM);
  EXPECT_TRUE(early.receive_all().ends_with(kEnd));
  EXPECT_TRUE(late.receive_all().ends_with(kEnd));
  early.end_sending();
  late.end_sending();
  EXPECT_EQ(server.process().wait(kPatience), 0);
}

TEST_F(ServerLive, AnAnswerGetsTheNewestState) {
  RunningTransmitter server(arguments(file_, {"--loop", "--stats", folder_.path() / "s.json"}));
  std::string hello;
  {
    RawClient classic = server.connect();
    EXPECT_EQ(classic.receive_until("}"), "{1}");
    // Who comes now begins with the same moment at the earliest, and sees eight more.
    RawClient clock = say_hello(server, "{hello v=2 window=0}", hello);
    for (int i = 0; i < 9; ++i) ASSERT_NE(clock.receive_until("}"), "");
    clock.reset();
    EXPECT_TRUE(classic.send("1"));
    EXPECT_EQ(classic.receive_until("}"), "{1}");
    EXPECT_TRUE(classic.send("-4"));
    EXPECT_EQ(classic.receive_all(), kEnd);
  }
  RawClient slow = say_hello(server, "{hello v=2 window=1}", hello);
  EXPECT_NE(slow.receive_until("}"), "");
  RawClient clock = say_hello(server, "{hello v=2 window=0}", hello);
  std::string newest;
  for (int i = 0; i < 9; ++i) ASSERT_NE(newest = clock.receive_until("}"), "");
  EXPECT_TRUE(slow.send("1"));
  const std::string next = slow.receive_until("}");
  while (newest != next) ASSERT_NE(newest = clock.receive_until("}"), "") << "it is not older";
  clock.reset();
  slow.reset();
  EXPECT_EQ(server.terminate(), 0);
  const auto stats = nlohmann::json::parse(folder_.read("s.json"));
  EXPECT_GE(stats["packets_merged"].get<int>(), 7 + 7);
}

TEST_F(ServerLive, EndsForEverybodyWithTheStream) {
  RunningTransmitter server(
      arguments(folder_.write("short.txt", "Beg_Stream\n1\n2\nEnd_Stream\n"), {}));
  for (int client = 0; client < 3; ++client) {
    std::string hello;
    RawClient any = say_hello(server, "{hello v=2 window=0}", hello);
    EXPECT_TRUE(hello.find("live=1 duration=500") != std::string::npos) << hello;
    EXPECT_TRUE(any.receive_all().ends_with(kEnd));
    EXPECT_FALSE(any.broken());
  }
  EXPECT_EQ(server.terminate(), 0);
}

TEST_F(ServerLive, WhoTakesNothingIsSkippedForCountedAndClosedInTime) {
  std::string all;
  for (int au = 2; au < 100; ++au) all += "+L" + std::to_string(au) + ":51";
  const std::string busy = folder_.write("busy.txt", numbered(1, all));
  RunningTransmitter server(
      arguments(busy, {"--loop", "--client-timeout", "1", "--stats", folder_.path() / "s.json"}));
  std::string hello;
  RawClient deaf = say_hello(server, "{hello v=2 window=0}", hello);
  RawClient other = say_hello(server, "{hello v=2 window=2}", hello);
  // The other one plays on until the deaf one has been closed.
  const std::string closed = "timed out: nothing was taken for 1000 ms (--client-timeout)";
  const auto until = std::chrono::steady_clock::now() + kPatience;
  while (server.log().find(closed) == std::string::npos &&
         std::chrono::steady_clock::now() < until) {
    for (int packet = 0; packet < 50; ++packet) {
      ASSERT_TRUE(other.receive_until("}").ends_with("}"));
      ASSERT_TRUE(other.send("1"));
    }
    ASSERT_FALSE(server.process().wait(1ms).has_value()) << "reads the log";
  }
  EXPECT_EQ(server.terminate(), 0);
  EXPECT_NE(server.log().find(closed), std::string::npos) << server.log();
  const auto stats = nlohmann::json::parse(folder_.read("s.json"));
  EXPECT_GT(stats["packets_merged"].get<int>(), 0);
}

TEST_F(ServerLive, WhatATransmitterThatStoodStillLeavesOutIsSaid) {
  RunningTransmitter server(arguments(file_, {"--loop"}));
  std::string reply;
  RawClient client = say_hello(server, "{hello v=2 window=0}", reply);
  EXPECT_FALSE(client.receive_until("}").empty()) << "the clock goes";
  server.process().signal(SIGSTOP);
  std::this_thread::sleep_for(std::chrono::milliseconds(1200));
  server.process().signal(SIGCONT);
  EXPECT_TRUE(logs(server, " moments of live streams were left out")) << server.log();
  client.reset();
  EXPECT_EQ(server.terminate(), 0);
}

TEST_F(ServerLive, ALoopWithoutTimeIsBadData) {
  const std::string still = folder_.write("still.txt", "Beg_Stream\n1;0\nEnd_Stream\n");
  const Finished done = run({program("au-transmitter"), "--live", "--loop", still});
  EXPECT_EQ(done.exit_code, 3);
  EXPECT_NE(done.err.find("takes no time at all"), std::string::npos) << done.err;
  EXPECT_EQ(done.out, "");
}

TEST(ServerMaxClients, RefusesByLevelAndLetsInWhenOneHasLeft) {
  RunningTransmitter server({"--max-clients", "1", stream_file("six_expressions.txt")});
  {
    RawClient inside = server.connect();
    EXPECT_EQ(inside.receive(kSixPackets[0].size()), kSixPackets[0]);
    std::string reply;
    RawClient talking = say_hello(server, "{hello v=2 window=4}", reply);
    EXPECT_EQ(reply, "{error 503 the server is full}");
    EXPECT_EQ(talking.receive_all(), "");
    RawClient classic = server.connect();
    EXPECT_TRUE(classic.send("1"));
    EXPECT_EQ(classic.receive_all(), "");
    EXPECT_TRUE(inside.send("1"));
    EXPECT_EQ(inside.receive(kSixPackets[1].size()), kSixPackets[1]) << "it notices nothing";
    EXPECT_TRUE(inside.send("-4"));
    EXPECT_EQ(inside.receive_all(), kEnd);
  }
  // The server notices in its own time that they have left.
  std::string reply;
  for (int attempt = 0; attempt < 200 && !reply.starts_with("{hello"); ++attempt) {
    static_cast<void>(say_hello(server, "{hello v=2 window=4}", reply));
  }
  EXPECT_TRUE(reply.starts_with("{hello v=2 window=4")) << reply;
  EXPECT_EQ(server.terminate(), 0);
}

}  // namespace
}  // namespace aucast::test
