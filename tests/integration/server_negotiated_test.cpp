// au-transmitter to clients that say hello.
#include <algorithm>

#include <gtest/gtest.h>

#include "tests/integration/server_running.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

using namespace std::chrono_literals;

constexpr const char* kFour = "Beg_Stream\n1:30,R12:80;40\n12\nL6:25,R6:25;1000\n0\nEnd_Stream\n";
const std::vector<std::string> kFourPackets = {"{1:30,R12:80;40}", "{12}", "{6:25;1000}", "{0}"};

bool has_field(const std::string& hello, const std::string& field) {
  return hello.find(" " + field + " ") != std::string::npos ||
         hello.find(" " + field + "}") != std::string::npos;
}

TEST(ServerNegotiated, GrantsWhatItServes) {
  const TempFolder folder;
  RunningTransmitter server({"--keyframe", "100", folder.write("four.txt", kFour).string()});
  std::string hello;
  const RawClient client = say_hello(server, "{hello v=2 window=3 delta=1 colour=blue}", hello);
  EXPECT_TRUE(hello.starts_with("{hello ")) << hello;
  EXPECT_TRUE(has_field(hello, "v=2")) << hello;
  EXPECT_TRUE(has_field(hello, "window=3")) << hello;
  EXPECT_TRUE(has_field(hello, "stream=four")) << hello;
  EXPECT_TRUE(has_field(hello, "keyframe=100")) << hello;
  EXPECT_TRUE(has_field(hello, "duration=1240")) << hello;
  EXPECT_TRUE(has_field(hello, "delta=1")) << hello;
  EXPECT_FALSE(has_field(hello, "live=1")) << hello;
}

TEST(ServerNegotiated, ChangesOnlyAreServedToWhoAsks) {
  RunningTransmitter server({stream_file("talk.txt")});
  const std::string answers(1000, '1');  // more than it has keyframes
  std::string hello;
  RawClient whole = say_hello(server, "{hello window=256}" + answers, hello);
  EXPECT_FALSE(has_field(hello, "delta=1")) << hello;
  RawClient changes = say_hello(server, "{hello window=256 delta=1}" + answers, hello);
  EXPECT_TRUE(has_field(hello, "delta=1")) << hello;
  const std::string all = whole.receive_until(kEnd);
  const std::string less = changes.receive_until(kEnd);
  EXPECT_EQ(all.find('~'), std::string::npos);
  EXPECT_EQ(less.substr(0, less.find('}')), all.substr(0, all.find('}'))) << "the first is full";
  EXPECT_TRUE(less.ends_with(kEnd));
  EXPECT_LT(less.size(), all.size());
  EXPECT_EQ(std::count(less.begin(), less.end(), '}'), std::count(all.begin(), all.end(), '}'));
}

TEST(ServerNegotiated, WindowIsFilledAndEveryAnswerLetsOneGo) {
  const TempFolder folder;
  RunningTransmitter server({folder.write("four.txt", kFour).string()});
  std::string reply;
  RawClient client = say_hello(server, "{hello v=2 window=2}", reply);
  EXPECT_TRUE(reply.starts_with("{hello "));
  EXPECT_EQ(client.receive_until(kFourPackets[1]), kFourPackets[0] + kFourPackets[1]);
  EXPECT_TRUE(client.silent(200ms)) << "the window is full";
  client.send("1");
  EXPECT_EQ(client.receive_until("}"), kFourPackets[2]);
  EXPECT_TRUE(client.silent(200ms));
  client.send("11");
  EXPECT_EQ(client.receive_until("}"), kFourPackets[3]);
  client.send("1");
  EXPECT_EQ(client.receive_all(), kEnd);
}

TEST(ServerNegotiated, StreamIsChosenByName) {
  RunningTransmitter server({stream_file("six_expressions.txt"), stream_file("happiness.txt")});
  std::string reply;
  RawClient client = say_hello(server, "{hello v=2 window=8 stream=happiness}", reply);
  EXPECT_TRUE(has_field(reply, "stream=happiness"));
  client.send("1");
  EXPECT_EQ(client.receive_all(), kSixPackets[4] + kEnd);
}

TEST(ServerNegotiated, UnknownStreamIsRefusedWithAReason) {
  RunningTransmitter server({stream_file("six_expressions.txt")});
  std::string reply;
  RawClient client = say_hello(server, "{hello v=2 stream=../etc/passwd}", reply);
  EXPECT_TRUE(reply.starts_with("{error 4")) << reply;
  EXPECT_EQ(client.receive_all(), "");
  EXPECT_FALSE(client.broken());
  RawClient other = say_hello(server, "{hello v=2 stream=none}", reply);
  EXPECT_TRUE(reply.starts_with("{error 404 ")) << reply;
  EXPECT_EQ(other.receive_all(), "");
}

TEST(ServerNegotiated, HelloInPiecesIsAwaited) {
  RunningTransmitter server({stream_file("happiness.txt")});
  // Again when this test itself was held up for longer than the grace.
  for (int attempt = 0; attempt < 20; ++attempt) {
    RawClient client = server.connect();
    client.send("{hel");
    // Longer than the grace: the brace has stopped it.
    if (!client.silent(400ms)) continue;
    client.send("lo v=2}");
    EXPECT_TRUE(client.receive_until("}").starts_with("{hello "));
    return;
  }
  FAIL() << "a hello that has begun does not stop the grace";
}

TEST(ServerNegotiated, HelloAfterTheGraceLeavesItClassic) {
  RunningTransmitter server({stream_file("happiness.txt")});
  RawClient client = server.connect();
  EXPECT_EQ(client.receive(kSixPackets[4].size()), kSixPackets[4]);
  client.send("{hello v=2 window=8}");
  EXPECT_TRUE(client.silent(200ms));
  client.send("1");
  EXPECT_EQ(client.receive_all(), kEnd);
}

TEST(ServerNegotiated, PauseHoldsTheWindow) {
  RunningTransmitter server({"--loop", stream_file("happiness.txt")});
  std::string reply;
  RawClient client = say_hello(server, "{hello v=2 window=2}", reply);
  EXPECT_TRUE(reply.starts_with("{hello "));
  EXPECT_EQ(client.receive(2 * kSixPackets[4].size()), kSixPackets[4] + kSixPackets[4]);
  client.send("-111");
  EXPECT_TRUE(client.silent(200ms)) << "paused: answers let nothing go";
  client.send("-3");
  EXPECT_EQ(client.receive(2 * kSixPackets[4].size()), kSixPackets[4] + kSixPackets[4]);
  client.send("-4");
  EXPECT_EQ(client.receive_all(), kEnd);
}

TEST(ServerNegotiated, LongStreamComesWholeThroughAWindow) {
  RunningTransmitter server({stream_file("talk.txt")});
  std::string reply;
  RawClient client = say_hello(server, "{hello v=2 window=64}", reply);
  EXPECT_TRUE(reply.starts_with("{hello "));
  std::size_t packets = 0;
  for (std::string packet = client.receive_until("}"); packet != kEnd;
       packet = client.receive_until("}")) {
    ASSERT_FALSE(packet.empty());
    ASSERT_TRUE(client.send("1"));
    ++packets;
  }
  EXPECT_GE(packets, 400U);
}

}  // namespace
}  // namespace aucast::test
