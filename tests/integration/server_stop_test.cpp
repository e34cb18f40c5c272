// How au-transmitter ends.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/integration/server_running.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

using namespace std::chrono_literals;

TEST(ServerStop, WithoutClientsItJustEnds) {
  RunningTransmitter server({stream_file("talk.txt")});
  EXPECT_EQ(server.terminate(), 0);
}

TEST(ServerStop, EveryClientGetsTheEnd) {
  RunningTransmitter server({stream_file("talk.txt")});
  RawClient waiting = server.connect();
  RawClient paused = server.connect();
  EXPECT_FALSE(waiting.receive_until("}").empty());
  EXPECT_FALSE(paused.receive_until("}").empty());
  paused.send("-1");
  EXPECT_TRUE(paused.silent(100ms));
  std::string reply;
  RawClient negotiated = say_hello(server, "{hello v=2 window=1}", reply);
  EXPECT_TRUE(reply.starts_with("{hello "));
  EXPECT_FALSE(negotiated.receive_until("}").empty());

  server.process().signal(SIGTERM);
  EXPECT_EQ(waiting.receive_all(), kEnd);
  EXPECT_EQ(paused.receive_all(), kEnd);
  EXPECT_EQ(negotiated.receive_all(), kEnd);
  EXPECT_EQ(server.process().wait(kPatience), 0);
  EXPECT_FALSE(waiting.broken() || paused.broken() || negotiated.broken());
}

/// The loader says what it found when it is through: it must not get there.
TEST(ServerStop, NobodyWaitsForAReload) {
  const TempFolder folder;
  const std::string header = "face_id,timestamp,success,AU12_r\n";
  const auto path = folder.write("a.csv", header + "0,0.0,1,1\n0,0.1,1,1\n0,0.2,1,1\n");
  RunningTransmitter server({path.string()});
  EXPECT_TRUE(logs(server, "AU scale 0-5"));
  std::string rows = header;
  for (int row = 0; row < 1'000'000; ++row) rows += "0," + std::to_string(row) + ",1,1\n";
  folder.write("a.csv", rows);
  server.process().signal(SIGHUP);
  EXPECT_TRUE(logs(server, "SIGHUP: reading"));
  EXPECT_EQ(server.terminate(), 0);
  const std::string found = "AU scale 0-5";
  const std::size_t first = server.log().find(found);
  EXPECT_EQ(server.log().find(found, first + found.size()), std::string::npos) << server.log();
}

TEST(ServerStop, InterruptIsTheSame) {
  RunningTransmitter server({stream_file("talk.txt")});
  RawClient client = server.connect();
  EXPECT_FALSE(client.receive_until("}").empty());
  server.process().signal(SIGINT);
  EXPECT_EQ(client.receive_all(), kEnd);
  EXPECT_EQ(server.process().wait(kPatience), 0);
}

TEST(ServerStop, PacketsUnderWayAreFinishedFirst) {
  RunningTransmitter server({"--loop", stream_file("six_expressions.txt")});
  RawClient client = server.connect();
  client.send(std::string(2000, '1'));
  EXPECT_EQ(client.receive(kSixPackets[0].size()), kSixPackets[0]);
  server.process().signal(SIGTERM);
  const std::string rest = client.receive_all();
  ASSERT_TRUE(rest.ends_with("}" + kEnd)) << rest;
  const std::string all = kSixPackets[0] + rest.substr(0, rest.size() - kEnd.size());
  for (std::size_t at = 0, index = 0; at < all.size(); ++index) {
    const std::string& packet = kSixPackets[index % kSixPackets.size()];
    ASSERT_EQ(all.substr(at, packet.size()), packet) << "packet " << index;
    at += packet.size();
  }
}

TEST(ServerStop, ClientThatStaysCannotHoldTheExit) {
  RunningTransmitter server({stream_file("talk.txt")});
  RawClient client = server.connect();
  EXPECT_FALSE(client.receive_until("}").empty());
  EXPECT_EQ(server.terminate(), 0) << "the client has not closed";
  EXPECT_EQ(client.receive_all(), kEnd);
}

TEST(ServerStop, SecondSignalEndsAtOnce) {
  const std::string said = "SIGINT again: ending at once";
  std::string log;
  // Again when this test itself was held up until the server had ended anyway.
  for (int attempt = 0; attempt < 10 && log.find(said) == std::string::npos; ++attempt) {
    RunningTransmitter server({stream_file("talk.txt")});
    RawClient client = server.connect();
    EXPECT_FALSE(client.receive_until("}").empty());
    server.process().signal(SIGTERM);
    EXPECT_EQ(client.receive_until(kEnd), kEnd);
    server.process().signal(SIGINT);
    EXPECT_EQ(server.process().wait(kPatience), 0);
    log = server.log();
  }
  EXPECT_NE(log.find(said), std::string::npos) << log;
}

/// Until the process is gone: also while the numbers are being written, when nothing runs any more.
TEST(ServerStop, SignalsThatKeepComingLeaveItAnOrderlyEnd) {
  const TempFolder folder;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1}) {
    RunningTransmitter server(
        {"--stats", (folder.path() / "s.json").string(), stream_file("talk.txt")});
    std::filesystem::remove(folder.path() / "s.json");  // it was tried at the start
    server.process().signal(SIGTERM);
    std::optional<int> ended;
    while (!ended) {
      server.process().signal(signal);
      ended = server.process().wait(1ms);
    }
    EXPECT_EQ(ended, 0) << signal;
    EXPECT_TRUE(nlohmann::json::accept(folder.read("s.json"))) << signal;
  }
}

TEST(ServerStop, AnyOtherSignalAtTheSameTimeDoesNotHoldTheExit) {
  for (const int other : {SIGUSR1, SIGHUP}) {
    for (const int end : {SIGINT, SIGTERM}) {
      RunningTransmitter server({stream_file("talk.txt")});
      // Both are there when it goes on.
      server.process().signal(SIGSTOP);
      server.process().signal(other);
      server.process().signal(end);
      server.process().signal(SIGCONT);
      EXPECT_EQ(server.process().wait(kPatience), 0) << other << " and " << end;
    }
  }
}

TEST(ServerStop, NobodyIsAcceptedAnyMore) {
  RunningTransmitter server({stream_file("talk.txt")});
  RawClient client = server.connect();
  EXPECT_FALSE(client.receive_until("}").empty());
  server.process().signal(SIGTERM);
  EXPECT_EQ(client.receive_until(kEnd), kEnd);
  RawClient late = server.connect();
  EXPECT_FALSE(late.ok());
  EXPECT_EQ(server.process().wait(kPatience), 0);
}

}  // namespace
}  // namespace aucast::test
