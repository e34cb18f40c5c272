// au-transmitter to clients that are broken, mute, dead or mean: one connection ends, nobody else
// notices.
#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/integration/server_running.h"
#include "tests/support/sanitized.h"

namespace aucast::test {
namespace {

using namespace std::chrono_literals;

/// Two ordinary clients around a hostile one: the first is in the middle of the stream meanwhile,
/// the second comes afterwards.
class ServerHostile : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(before_.ok());
    ASSERT_EQ(before_.receive(kSixPackets[0].size()), kSixPackets[0]);
  }

  void TearDown() override {
    for (std::size_t index = 1; index < kSixPackets.size(); ++index) {
      ASSERT_TRUE(before_.send("1"));
      ASSERT_EQ(before_.receive(kSixPackets[index].size()), kSixPackets[index]);
    }
    before_.send("1");
    EXPECT_EQ(before_.receive_all(), kEnd);
    // Closed before the server is: it would wait for a last word otherwise.
    before_.end_sending();
    RawClient after = server_.connect();
    expect_six_packets(after);
    after.end_sending();
    EXPECT_EQ(server_.terminate(), 0) << server_.log();
    for (const std::string& text : expected_log_) {
      EXPECT_NE(server_.log().find(text), std::string::npos) << text << "\n" << server_.log();
    }
  }

  /// What the log says of this client when it is closed; looked for at the end.
  void expect_closed(const RawClient& client, const std::string& reason) {
    expected_log_.push_back("127.0.0.1:" + std::to_string(client.local_port()) +
                            ": closed: " + reason);
  }

  RunningTransmitter server_{{stream_file("six_expressions.txt")}};
  RawClient before_ = server_.connect();

 private:
  std::vector<std::string> expected_log_;
};

TEST_F(ServerHostile, GarbageIsClosedWithItsPlaceAndEscaped) {
  RawClient client = server_.connect();
  client.send("1\x1b[31mGET / HTTP/1.1\r\n\r\n");
  EXPECT_TRUE(client.wait_for_end());
  expect_closed(client, "protocol error: ");
}

TEST_F(ServerHostile, WhatWasSentBeforeTheGarbageArrives) {
  RawClient client = server_.connect();
  EXPECT_EQ(client.receive(kSixPackets[0].size()), kSixPackets[0]);
  client.send("1x");
  EXPECT_EQ(client.receive_all(), kSixPackets[1]);
  EXPECT_FALSE(client.broken()) << "an orderly end";
}

TEST_F(ServerHostile, AnswersBeyondTheLimitAreClosed) {
  RawClient client = server_.connect();
  client.send("-1" + std::string(5000, '1'));
  EXPECT_TRUE(client.wait_for_end());
  expect_closed(client, "protocol error: ");
}

TEST_F(ServerHostile, TenMegabytesOfDigitsAreClosed) {
  RawClient client = server_.connect();
  const std::string digits(1 << 20, '7');
  for (int megabyte = 0; megabyte < 10 && client.send(digits); ++megabyte) continue;
  EXPECT_TRUE(client.wait_for_end());
  expect_closed(client, "protocol error: ");
}

TEST_F(ServerHostile, HelloWithoutEndIsClosed) {
  std::string reply;
  RawClient client = say_hello(server_, "{hello v=2 stream=" + std::string(2000, 'a'), reply);
  EXPECT_TRUE(reply.starts_with("{error 400 ")) << reply;
  EXPECT_TRUE(client.wait_for_end());
  expect_closed(client, "refused: 400 ");
}

TEST_F(ServerHostile, HelloThatNeverEndsIsClosedInTime) {
  std::string reply;
  const RawClient client = say_hello(server_, "{hello v=2", reply);
  EXPECT_TRUE(reply.starts_with("{error 400 ")) << reply;
}

TEST_F(ServerHostile, MuteClientWaitsAlone) {
  RawClient client = server_.connect();
  EXPECT_EQ(client.receive(kSixPackets[0].size()), kSixPackets[0]);
  EXPECT_TRUE(client.silent(200ms));
}

TEST_F(ServerHostile, ResetInTheMiddleIsNoticed) {
  RawClient client = server_.connect();
  EXPECT_EQ(client.receive(kSixPackets[0].size()), kSixPackets[0]);
  client.send("1");
  EXPECT_EQ(client.receive(kSixPackets[1].size()), kSixPackets[1]);
  expect_closed(client, "peer gone");
  client.reset();
}

TEST_F(ServerHostile, ResetBeforeAnythingIsNoticed) {
  RawClient client = server_.connect();
  // One that is gone before it is accepted has no address to be named by.
  const std::string peer = "127.0.0.1:" + std::to_string(client.local_port());
  EXPECT_TRUE(logs(server_, peer + ": connected")) << server_.log();
  expect_closed(client, "peer gone");
  client.reset();
}

TEST_F(ServerHostile, VanishingWhilePausedIsNoticed) {
  RawClient paused = server_.connect();
  EXPECT_EQ(paused.receive(kSixPackets[0].size()), kSixPackets[0]);
  paused.send("-1");
  EXPECT_TRUE(paused.silent(100ms));
  expect_closed(paused, "peer gone");
  RawClient also_paused = server_.connect();
  EXPECT_EQ(also_paused.receive(kSixPackets[0].size()), kSixPackets[0]);
  also_paused.send("-1");
  EXPECT_TRUE(also_paused.silent(100ms));
  expect_closed(also_paused, "peer gone");
  paused.reset();
  also_paused.end_sending();
  EXPECT_EQ(also_paused.receive_all(), "");
}

TEST_F(ServerHostile, ManyThatComeAndGo) {
  for (int number = 0; number < 200; ++number) {
    RawClient client = server_.connect();
    ASSERT_TRUE(client.ok());
    if (number % 3 == 0) client.reset();
    if (number % 3 == 1) client.send("}");
  }
}

/// Resident memory of a process in kB.
long resident_kb(pid_t pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmRSS:")) return std::stol(line.substr(6));
  }
  return -1;
}

TEST(ServerHostileLoop, OneThatAsksButNeverReadsCostsLittleAndDelaysNobody) {
  RunningTransmitter server({"--loop", stream_file("talk.txt")});
  const long before = resident_kb(server.process().pid());
  RawClient greedy = server.connect();
  // Ten megabytes of answers ask for hundreds of megabytes of packets; none is read.
  const std::string answers(1 << 20, '1');
  for (int megabyte = 0; megabyte < 10 && greedy.send(answers, 500ms); ++megabyte) continue;

  RawClient other = server.connect();
  for (int packet = 0; packet < 300; ++packet) {
    ASSERT_TRUE(other.receive_until("}").ends_with("}")) << packet;
    ASSERT_TRUE(other.send("1"));
  }
  // A sanitizer keeps freed memory for a while and would be what is measured.
  if (!kSanitized) {
    EXPECT_LT(resident_kb(server.process().pid()) - before, 64 * 1024);
  }
  EXPECT_EQ(server.terminate(), 0) << "it cannot hold up the exit either";
}

TEST(ServerClientTimeout, ClosesWhoOwesAnAnswerAndSparesThePaused) {
  RunningTransmitter server({"--client-timeout", "2", stream_file("six_expressions.txt")});
  RawClient paused = server.connect();
  EXPECT_EQ(paused.receive(kSixPackets[0].size()), kSixPackets[0]);
  paused.send("-1");
  RawClient mute = server.connect();
  EXPECT_EQ(mute.receive_all(), kSixPackets[0]);
  EXPECT_TRUE(mute.ended());
  EXPECT_FALSE(mute.broken());

  EXPECT_TRUE(paused.silent(2500ms)) << "paused for longer than the time-out";
  paused.send("-3");
  EXPECT_EQ(paused.receive(kSixPackets[1].size()), kSixPackets[1]);
  EXPECT_EQ(server.terminate(), 0);
  EXPECT_NE(server.log().find("closed: timed out: no answer for 2000 ms (--client-timeout)"),
            std::string::npos)
      << server.log();
}

TEST(ServerDescriptors, RunningOutOfThemIsSaidAndSurvived) {
  if (kSanitized) GTEST_SKIP() << "the sanitizers need descriptors themselves, for their checks";
  Process process({"sh", "-c",
                   "ulimit -n 20; exec " + program("au-transmitter") + " --port 0 " +
                       stream_file("six_expressions.txt")});
  const auto line = process.read_line(kPatience);
  ASSERT_TRUE(line.has_value()) << process.err();
  const std::string address = line->substr(line->rfind(' ') + 1);
  {
    std::vector<RawClient> crowd;
    for (int number = 0; number < 30; ++number) crowd.emplace_back(address);
    // The last one was taken by the system, but not by the program.
    EXPECT_TRUE(crowd.back().silent(500ms));
    RawClient& first = crowd.front();
    expect_six_packets(first);
  }
  RawClient later(address);
  expect_six_packets(later);
  process.signal(SIGTERM);
  EXPECT_EQ(process.wait(kPatience), 0);
  EXPECT_NE(process.err().find("cannot accept connections for now: Too many open files"),
            std::string::npos)
      << process.err();
}

}  // namespace
}  // namespace aucast::test
