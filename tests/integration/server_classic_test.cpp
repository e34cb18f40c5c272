// au-transmitter to clients that know level 1 only.
#include <gtest/gtest.h>

#include "tests/integration/server_running.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

using namespace std::chrono_literals;

TEST(ServerClassic, SixPacketsThenTheEndToAClientThatAnswers) {
  RunningTransmitter server({stream_file("six_expressions.txt")});
  RawClient client = server.connect();
  expect_six_packets(client);
}

TEST(ServerClassic, NextPacketWaitsForTheAnswer) {
  RunningTransmitter server({stream_file("six_expressions.txt")});
  RawClient client = server.connect();
  EXPECT_EQ(client.receive(kSixPackets[0].size()), kSixPackets[0]);
  EXPECT_TRUE(client.silent(200ms));
  client.send("1");
  EXPECT_EQ(client.receive(kSixPackets[1].size()), kSixPackets[1]);
  EXPECT_TRUE(client.silent(200ms));
}

TEST(ServerClassic, EarlyAnswersWithHalfCloseAsNcSendsThem) {
  RunningTransmitter server({stream_file("six_expressions.txt")});
  RawClient client = server.connect();
  client.send("1111111");
  client.end_sending();
  EXPECT_EQ(client.receive_all(), joined(kSixPackets) + kEnd);
  EXPECT_FALSE(client.broken());
}

TEST(ServerClassic, NcIsAClient) {
  if (run({"sh", "-c", "command -v nc"}).exit_code != 0) GTEST_SKIP() << "nc is not here";
  RunningTransmitter server({stream_file("six_expressions.txt")});
  const Finished nc =
      run({"sh", "-c", "printf '1111111' | nc -w 10 127.0.0.1 " + server.port()}, {}, kPatience);
  EXPECT_EQ(nc.out, joined(kSixPackets) + kEnd);
}

TEST(ServerClassic, BlanksBetweenAnswersAreIgnored) {
  RunningTransmitter server({stream_file("six_expressions.txt")});
  RawClient client = server.connect();
  client.send(" 1\r\n1 1\n1\n1\n1\n");
  EXPECT_EQ(client.receive_all(), joined(kSixPackets) + kEnd);
}

TEST(ServerClassic, HalfCloseBeforeEverythingIsAnsweredEndsThere) {
  RunningTransmitter server({stream_file("six_expressions.txt")});
  RawClient client = server.connect();
  client.send("11");
  client.end_sending();
  EXPECT_EQ(client.receive_all(), kSixPackets[0] + kSixPackets[1] + kSixPackets[2]);
  EXPECT_FALSE(client.broken());
  EXPECT_EQ(server.terminate(), 0);
  EXPECT_NE(server.log().find("peer gone"), std::string::npos) << server.log();
}

TEST(ServerClassic, PauseHoldsTheStreamAndResumeGoesOn) {
  RunningTransmitter server({stream_file("six_expressions.txt")});
  RawClient client = server.connect();
  EXPECT_EQ(client.receive(kSixPackets[0].size()), kSixPackets[0]);
  client.send("-1");
  EXPECT_TRUE(client.silent(200ms));
  client.send("-3");
  EXPECT_EQ(client.receive(kSixPackets[1].size()), kSixPackets[1]) << "-1 answered the first";
  client.send("-1-3");
  EXPECT_EQ(client.receive(kSixPackets[2].size()), kSixPackets[2]);
}

TEST(ServerClassic, PausedClientGetsTheEndAfterItResumes) {
  RunningTransmitter server({stream_file("happiness.txt")});
  RawClient client = server.connect();
  EXPECT_EQ(client.receive(kSixPackets[4].size()), kSixPackets[4]);
  client.send("-1");
  EXPECT_TRUE(client.silent(200ms));
  client.send("-3");
  EXPECT_EQ(client.receive_all(), kEnd);
}

TEST(ServerClassic, StopIsHonouredAtOnce) {
  RunningTransmitter server({stream_file("talk.txt")});
  RawClient client = server.connect();
  const std::string first = client.receive_until("}");
  EXPECT_TRUE(first.starts_with("{"));
  client.send("-4");
  EXPECT_EQ(client.receive_all(), kEnd);
  EXPECT_FALSE(client.broken());
}

TEST(ServerClassic, StopWhilePausedIsHonoured) {
  RunningTransmitter server({stream_file("talk.txt")});
  RawClient client = server.connect();
  EXPECT_FALSE(client.receive_until("}").empty());
  client.send("-1-4");
  EXPECT_EQ(client.receive_all(), kEnd);
}

TEST(ServerClassic, LoopStartsAgainWithoutAnEnd) {
  RunningTransmitter server({"--loop", stream_file("six_expressions.txt")});
  RawClient client = server.connect();
  const std::string thrice = joined(kSixPackets) + joined(kSixPackets) + joined(kSixPackets);
  client.send(std::string(3 * kSixPackets.size() - 1, '1'));
  EXPECT_EQ(client.receive(thrice.size()), thrice);
  client.send("-4");
  EXPECT_EQ(client.receive_all(), kEnd);
}

TEST(ServerClassic, FirstStreamIsTheOneAClassicClientGets) {
  RunningTransmitter server({stream_file("sadness.txt"), stream_file("six_expressions.txt")});
  RawClient client = server.connect();
  client.send("1");
  EXPECT_EQ(client.receive_all(), kSixPackets[5] + kEnd);
}

TEST(ServerClassic, WeakUnitsAreLeftOutByClassicMin) {
  const TempFolder folder;
  const auto file = folder.write("weak.txt", "Beg_Stream\n1:19,2:20,L12:45;40\n4:5\nEnd_Stream\n");
  {
    RunningTransmitter server({file.string()});
    RawClient client = server.connect();
    client.send("11");
    EXPECT_EQ(client.receive_all(), "{2,12}{0}{-2}");
  }
  RunningTransmitter server({"--classic-min", "5", file.string()});
  RawClient client = server.connect();
  client.send("11");
  EXPECT_EQ(client.receive_all(), "{1,2,12}{4}{-2}");
}

TEST(ServerClassic, ManyClientsAtOnceEachAtItsOwnPace) {
  RunningTransmitter server({stream_file("six_expressions.txt")});
  std::vector<RawClient> clients;
  for (int number = 0; number < 40; ++number) clients.push_back(server.connect());
  for (const std::string& packet : kSixPackets) {
    for (std::size_t index = 0; index < clients.size(); ++index) {
      // Every fourth client only watches: it never answers.
      if (index % 4 == 3) continue;
      ASSERT_EQ(clients[index].receive(packet.size()), packet) << "client " << index;
      ASSERT_TRUE(clients[index].send("1"));
    }
  }
  for (std::size_t index = 0; index < clients.size(); ++index) {
    if (index % 4 == 3) {
      EXPECT_EQ(clients[index].receive(kSixPackets[0].size()), kSixPackets[0]);
      EXPECT_FALSE(clients[index].ended());
    } else {
      EXPECT_EQ(clients[index].receive_all(), kEnd);
    }
  }
}

}  // namespace
}  // namespace aucast::test
