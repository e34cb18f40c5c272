// au-transmitter as a relay of other au-transmitters, over loopback.
#include <csignal>
#include <filesystem>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/integration/growing_table.h"
#include "tests/integration/server_running.h"
#include "tests/support/fault_proxy.h"
#include "tests/support/scripted_server.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

/// A port that nothing listens on.
std::string free_port() {
  RunningTransmitter server({stream_file("six_expressions.txt")});
  std::string port = server.port();
  EXPECT_EQ(server.terminate(), 0);
  return port;
}

std::string address_of(const RunningTransmitter& server, const std::string& stream) {
  return "aucast://" + server.address() + "/" + stream;
}

/// All that a client gets which answers everything beforehand.
std::string whole(const RunningTransmitter& server, const std::string& hello) {
  std::string reply;
  RawClient client = say_hello(server, hello, reply);
  client.send(std::string(4000, '1'));
  return reply + client.receive_all();
}

class ServerRelay : public ::testing::Test {
 protected:
  RawClient join(const RunningTransmitter& server) {
    std::string reply;
    RawClient client = say_hello(server, "{hello v=2 window=0 delta=1}", reply);
    EXPECT_NE(reply.find(" stream=webcam live=1 "), std::string::npos) << reply;
    return client;
  }
  /// A source that the test writes, and its server.
  RunningTransmitter origin() {
    webcam_ = folder_.write("webcam.csv", kHeader + row(0, "1") + row(1, "1"));
    return RunningTransmitter({"--follow", "--source-timeout", "0", webcam_.string()});
  }

  TempFolder folder_;
  std::filesystem::path webcam_;
};

TEST_F(ServerRelay, ARecordedStreamIsTheSameBytesBehindTwoRelays) {
  RunningTransmitter origin({stream_file("talk.txt")});
  RunningTransmitter first({address_of(origin, "talk")});
  RunningTransmitter second({address_of(first, "talk")});
  for (const char* hello : {"{hello v=2 window=64 stream=talk delta=1}", "{hello v=2 window=64}",
                            "{hello v=2 window=64 delta=1 from=5000}"}) {
    const std::string direct = whole(origin, hello);
    EXPECT_TRUE(direct.ends_with(kEnd)) << hello;
    EXPECT_EQ(whole(second, hello), direct) << hello;
  }
  EXPECT_TRUE(logs(first, "talk: it is here whole")) << first.log();
}

TEST_F(ServerRelay, AStreamWhoseNameIsTakenIsNotServedUnderItToo) {
  RunningTransmitter origin({stream_file("talk.txt")});
  RunningTransmitter relay({stream_file("talk.txt"), "aucast://" + origin.address()});
  EXPECT_TRUE(logs(relay, "its first stream is 'talk', and another one here has that name"))
      << relay.log();
  RawClient client = relay.connect();
  client.send("{streams}");
  EXPECT_EQ(client.receive_until("}"), "{streams talk}");
}

TEST_F(ServerRelay, ARecordedStreamLosesAndDoublesNothingWhenItsParentIsKilledMidway) {
  RunningTransmitter first({stream_file("talk.txt")});
  RunningTransmitter second({stream_file("talk.txt")});
  // Slow, so that there is a midway.
  FaultProxy slow(first.address(), {.kilobits = 100}, 1);
  RunningTransmitter relay({"aucast://" + slow.address() + "," + second.address() + "/talk"});
  ASSERT_TRUE(logs(relay, "talk: recorded, from " + slow.address())) << relay.log();
  // Full packets: where the next parent goes on, the first one is no change of the one before.
  const char* const hello = "{hello v=2 window=64 stream=talk}";
  std::string begin;
  RawClient client = say_hello(relay, hello, begin);
  client.send(std::string(4000, '1'));
  begin += client.receive(2000);
  first.process().signal(SIGKILL);
  const std::string all = begin + client.receive_all();
  EXPECT_TRUE(logs(relay, "talk: goes on with " + second.address() + " where it was cut off"))
      << relay.log();
  const std::string direct = whole(second, hello);
  EXPECT_TRUE(direct.ends_with(kEnd));
  EXPECT_EQ(all.size(), direct.size());
  EXPECT_TRUE(all == direct);
  EXPECT_TRUE(whole(relay, hello) == direct) << "what it has kept";
}

TEST_F(ServerRelay, ALoopIsTheSameBytesBehindTwoRelaysWhoseOriginIsGone) {
  RunningTransmitter origin({"--loop", stream_file("six_expressions.txt")});
  RunningTransmitter first({address_of(origin, "six_expressions")});
  RunningTransmitter second({address_of(first, "six_expressions")});
  ASSERT_TRUE(logs(second, "six_expressions: it is here whole")) << second.log();
  // Beyond the first turn, which takes 1500 ms.
  for (const char* hello : {"{hello v=2 window=64 delta=1}", "{hello v=2 window=3 from=4000}"}) {
    std::string direct;
    std::string far;
    RawClient near_client = say_hello(origin, hello, direct);
    RawClient far_client = say_hello(second, hello, far);
    EXPECT_EQ(far, direct) << "without a length";
    for (RawClient* const client : {&near_client, &far_client}) client->send(std::string(40, '1'));
    constexpr std::size_t kThreeTurns = 300;
    EXPECT_EQ(far_client.receive(kThreeTurns), near_client.receive(kThreeTurns)) << hello;
  }
  std::string reply;
  RawClient client = say_hello(second, "{hello v=2 window=64}", reply);
  origin.process().signal(SIGKILL);
  first.process().signal(SIGKILL);
  client.send(std::string(4000, '1'));
  EXPECT_EQ(client.receive(20'000).size(), 20'000U) << "goes on";
}

TEST_F(ServerRelay, ALiveLoopGoesOnFromTurnToTurn) {
  const auto turn = folder_.write("turn.txt", "Beg_Stream\n1;10@10\n2;10@20\nEnd_Stream\n");
  RunningTransmitter origin({"--live", "--loop", turn.string()});
  RunningTransmitter relay({address_of(origin, "turn")});
  std::string reply;
  RawClient client = say_hello(relay, "{hello v=2 window=0}", reply);
  for (int turns = 0; turns < 5; ++turns) {
    EXPECT_NE(client.receive_until("{1;10@10}").find("{1;10@10}"), std::string::npos);
    EXPECT_NE(client.receive_until("{2;10@20}").find("{2;10@20}"), std::string::npos);
  }
}

TEST_F(ServerRelay, AClassicClientOfARelayGetsClassicPackets) {
  RunningTransmitter origin({stream_file("six_expressions.txt")});
  RunningTransmitter relay({address_of(origin, "")});
  ASSERT_TRUE(logs(relay, "is here whole")) << relay.log();
  RawClient client = relay.connect();
  ASSERT_TRUE(client.send("1"));
  ASSERT_EQ(client.receive(kSixPackets[0].size()), kSixPackets[0]);
}

TEST_F(ServerRelay, ALiveMomentReachesTheClientOfASecondRelay) {
  RunningTransmitter server = origin();
  RunningTransmitter first({address_of(server, "webcam")});
  RunningTransmitter second({address_of(first, "webcam")});
  RawClient direct = join(server);
  RawClient far = join(second);
  // In between the face may go to neutral, on a machine that is slow.
  for (int frame = 2; frame < 12; ++frame) {
    append(webcam_, row(frame, frame % 2 == 0 ? "3" : "4"));
    const std::string begin = frame % 2 == 0 ? "{12:60;" : "{12:80;";
    EXPECT_NE(direct.receive_until(begin).find(begin), std::string::npos);
    EXPECT_NE(far.receive_until(begin).find(begin), std::string::npos);
    EXPECT_EQ(far.receive_until("}"), direct.receive_until("}")) << "the same time";
  }
}

TEST_F(ServerRelay, OneConnectionThereServesManyClientsHere) {
  RunningTransmitter server = origin();
  RunningTransmitter relay({address_of(server, "webcam")});
  std::vector<RawClient> clients;
  for (int i = 0; i < 10; ++i) clients.push_back(join(relay));
  append(webcam_, row(2, "5"));
  for (RawClient& client : clients) {
    EXPECT_NE(client.receive_until("{12;").find("{12;"), std::string::npos);
  }
  relay.process().signal(SIGUSR1);
  EXPECT_TRUE(logs(relay, "status: upstream webcam from " + server.address() + ": connections 1"))
      << relay.log();
  server.process().signal(SIGUSR1);
  EXPECT_TRUE(logs(server, "clients 1, paused 0")) << server.log();
}

TEST_F(ServerRelay, WhenALiveParentIsKilledTheNextOneIsTaken) {
  RunningTransmitter first = origin();
  RunningTransmitter second({"--follow", "--source-timeout", "0", webcam_.string()});
  RunningTransmitter relay({"aucast://" + first.address() + "," + second.address() + "/webcam"});
  RawClient client = join(relay);
  EXPECT_NE(client.receive_until("}"), "");
  first.process().signal(SIGKILL);
  EXPECT_TRUE(logs(relay, "webcam: goes on with " + second.address())) << relay.log();
  EXPECT_NE(relay.log().find(" s is missing"), std::string::npos) << relay.log();
  append(webcam_, row(2, "3"));
  const std::string seen = client.receive_until("{12:60;");
  EXPECT_NE(seen.find("{12:60;"), std::string::npos);
  EXPECT_EQ(seen.find(kEnd), std::string::npos);
}

TEST_F(ServerRelay, AParentThatLiesCostsALineInTheLog) {
  RunningTransmitter good = origin();
  const std::string live = "{hello v=2 window=50 delta=1 stream=webcam live=1}";
  std::string flood;
  for (int i = 0; i < 3000; ++i) flood += "{1}";
  const std::pair<std::string, std::string> parents[] = {
      {"SSH-2.0-OpenSSH_9.2\r\n", "what is not the protocol"},
      {std::string(100'000, '\0'), "what is not the protocol"},
      {live + "{1" + std::string(100'000, ' '), "no closing brace within 4096 bytes"},
      {live + flood, "it sends more than 2000 keyframes, voice packets and captions a second"},
      {"{hello v=2 window=50 stream=other live=1}{1}", "it sends the stream 'other'"},
      {"{hello v=2 window=50 stream=webcam duration=40}{garbage}", "what is not the protocol"},
  };
  int frame = 2;
  for (const auto& [bytes, reason] : parents) {
    SCOPED_TRACE(reason);
    ScriptedServer bad({Accept{}, ExpectHello{}, Send{bytes}});
    const std::string first = "127.0.0.1:" + std::to_string(bad.port());
    RunningTransmitter relay({"aucast://" + first + "," + good.address() + "/webcam"});
    EXPECT_TRUE(logs(relay, "webcam: " + first + ": ")) << relay.log();
    EXPECT_TRUE(logs(relay, reason)) << relay.log();
    const bool has_sent = bytes.ends_with(flood);
    EXPECT_TRUE(logs(relay, (has_sent ? "goes on with " : "live, from ") + good.address()))
        << relay.log();
    RawClient client = join(relay);
    append(webcam_, row(frame, frame % 2 == 0 ? "3" : "4"));
    const std::string sent = frame++ % 2 == 0 ? "{12:60;" : "{12:80;";
    EXPECT_NE(client.receive_until(sent).find(sent), std::string::npos);
    EXPECT_EQ(relay.terminate(), 0);
  }
}

TEST_F(ServerRelay, ALiveStreamEndsForClientsWhenNoParentIsFoundInTime) {
  RunningTransmitter server = origin();
  RunningTransmitter relay({"--upstream-wait", "0.2", address_of(server, "webcam")});
  RawClient client = join(relay);
  EXPECT_NE(client.receive_until("}"), "");
  server.process().signal(SIGKILL);
  EXPECT_TRUE(client.receive_all().ends_with(kEnd));
  EXPECT_TRUE(logs(relay, "no parent sends it: it ends for the clients there")) << relay.log();
}

TEST_F(ServerRelay, AClientMayComeBeforeTheStream) {
  const std::string port = free_port();
  RunningTransmitter relay({"aucast://127.0.0.1:" + port + "/six_expressions"});
  RawClient client = relay.connect();
  ASSERT_TRUE(client.send("{hello v=2 window=8}"));
  ASSERT_TRUE(logs(relay, "cannot be reached")) << relay.log();
  Process origin({program("au-transmitter"), "--port", port, stream_file("six_expressions.txt")});
  ASSERT_TRUE(origin.read_line(kPatience).has_value()) << origin.err();
  EXPECT_TRUE(client.receive_until("}").starts_with("{hello v=2 window=8 stream=six_expressions"));
}

TEST_F(ServerRelay, WhoWaitsInVainIsTold) {
  RunningTransmitter relay({"--upstream-wait", "0.2", "aucast://127.0.0.1:" + free_port() + "/x"});
  std::string reply;
  say_hello(relay, "{hello v=2 stream=x}", reply);
  EXPECT_TRUE(reply.starts_with("{error 503 the stream has not come")) << reply;
  say_hello(relay, "{hello v=2 stream=y}", reply);
  EXPECT_TRUE(reply.starts_with("{error 404 ")) << reply;
}

TEST_F(ServerRelay, ARelayThatDialsItselfIsRefused) {
  const std::string port = free_port();
  Process relay({program("au-transmitter"), "--port", port, "aucast://127.0.0.1:" + port + "/x"});
  ASSERT_TRUE(relay.read_line(kPatience).has_value()) << relay.err();
  EXPECT_TRUE(
      logs(relay, "the server refused: 508 the stream would come back to the relay that asks"))
      << relay.err();
}

TEST_F(ServerRelay, ARelayIsRefusedByTheOneThatItFeeds) {
  RunningTransmitter server = origin();
  const std::string port = free_port();
  // The first one is fed by the origin as long as that lives, then asks the second.
  RunningTransmitter first(
      {"aucast://" + server.address() + ",127.0.0.1:" + port + "/webcam", "--upstream-wait", "20"});
  RawClient client = join(first);
  Process second({program("au-transmitter"), "--port", port, address_of(first, "webcam")});
  ASSERT_TRUE(second.read_line(kPatience).has_value()) << second.err();
  ASSERT_TRUE(logs(second, "webcam: live, from")) << second.err();
  server.process().signal(SIGKILL);
  EXPECT_TRUE(logs(first, "508 the stream would come back")) << first.log();
}

TEST_F(ServerRelay, AnAddressThatCannotBeRightIsAUsageError) {
  for (const char* address : {"aucast://", "aucast://a/b/c", "aucast://a:0/x"}) {
    const Finished finished = run({program("au-transmitter"), address});
    EXPECT_EQ(finished.exit_code, 2) << address;
    EXPECT_NE(finished.err.find("is no address of a stream"), std::string::npos) << finished.err;
  }
}

TEST_F(ServerRelay, ATokenGoesToNobodyInPlainText) {
  const auto token = folder_.write("token", "0123456789abcdef");
  const Finished finished = run({program("au-transmitter"), "--port", "0", "--upstream-token-file",
                                 token.string(), "aucast://example.org/talk"});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_NE(finished.err.find("use aucasts://"), std::string::npos) << finished.err;
}

TEST_F(ServerRelay, AParentsTokenIsShown) {
  const auto token = folder_.write("token", "0123456789abcdef");
  RunningTransmitter origin({"--token-file", token.string(), stream_file("six_expressions.txt")});
  RunningTransmitter relay(
      {"--upstream-token-file", token.string(), address_of(origin, "six_expressions")});
  EXPECT_TRUE(logs(relay, "is here whole")) << relay.log();
}

}  // namespace
}  // namespace aucast::test
