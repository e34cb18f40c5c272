// Publishers that dial the server which serves their streams, over loopback.
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include <gtest/gtest.h>

#include "tests/integration/growing_table.h"
#include "tests/integration/server_running.h"
#include "tests/support/certificates.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

constexpr const char* kToken = "0123456789abcdef";
constexpr const char* kOther = "fedcba9876543210";

class ServerPush : public ::testing::Test {
 protected:
  ServerPush() {
    token_ = folder_.write("token", kToken).string();
    other_ = folder_.write("other", kOther).string();
    publishers_ = folder_.write("publishers", std::string(kToken) + "\n" + kOther + " seminar\n");
    std::filesystem::permissions(publishers_, static_cast<std::filesystem::perms>(0600));
    webcam_ = folder_.write("webcam.csv", kHeader + row(0, "1") + row(1, "1"));
  }

  /// A server without a stream of its own.
  [[nodiscard]] std::vector<std::string> accepting(std::vector<std::string> more = {}) const {
    std::vector<std::string> all{"--accept-push", publishers_.string()};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  [[nodiscard]] std::vector<std::string> pushing(const std::string& address,
                                                 std::vector<std::string> what) const {
    std::vector<std::string> all{"--push", address, "--push-token-file", token_};
    all.insert(all.end(), what.begin(), what.end());
    return all;
  }
  [[nodiscard]] std::vector<std::string> live() const {
    return {"--follow", "--source-timeout", "0", webcam_.string()};
  }
  static std::string address_of(const RunningTransmitter& server, const std::string& stream) {
    return "aucast://" + server.address() + "/" + stream;
  }
  static RawClient watch(const RunningTransmitter& server, const std::string& stream) {
    std::string reply;
    RawClient client =
        say_hello(server, "{hello v=2 window=0 delta=1 stream=" + stream + "}", reply);
    EXPECT_NE(reply.find(" stream=" + stream + " live=1 "), std::string::npos) << reply;
    return client;
  }
  /// All that a client gets which answers everything beforehand.
  static std::string whole(const RunningTransmitter& server, const std::string& hello) {
    std::string reply;
    RawClient client = say_hello(server, hello, reply);
    client.send(std::string(1000, '1'));
    return reply + client.receive_all();
  }
  static std::string text_of(const std::string& stream) {
    std::ifstream file(stream_file(stream));
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// What the server says to who says that.
  static std::string answer(const RunningTransmitter& server, const std::string& hello) {
    std::string reply;
    say_hello(server, hello, reply);
    return reply;
  }
  static std::string free_port() {
    RunningTransmitter server({stream_file("six_expressions.txt")});
    std::string port = server.port();
    EXPECT_EQ(server.terminate(), 0);
    return port;
  }

  TempFolder folder_;
  std::string token_;
  std::string other_;  ///< for one name only
  std::filesystem::path publishers_;
  std::filesystem::path webcam_;
};

TEST_F(ServerPush, ALiveMomentReachesTheClientOfTheServerThatWasDialled) {
  RunningTransmitter campus(accepting());
  RunningTransmitter home(pushing(address_of(campus, "talk"), live()));
  ASSERT_TRUE(logs(campus, "talk: live, from")) << campus.log() << home.log();
  RawClient far = watch(campus, "talk");
  RawClient near = watch(home, "webcam");
  for (int frame = 2; frame < 8; ++frame) {
    append(webcam_, row(frame, frame % 2 == 0 ? "3" : "4"));
    const std::string begin = frame % 2 == 0 ? "{12:60;" : "{12:80;";
    EXPECT_NE(near.receive_until(begin).find(begin), std::string::npos);
    EXPECT_NE(far.receive_until(begin).find(begin), std::string::npos);
    EXPECT_EQ(far.receive_until("}"), near.receive_until("}")) << "the same time";
  }
  home.process().signal(SIGUSR1);
  EXPECT_TRUE(logs(home, "status: push talk to " + campus.address() + ": taken, connections 1"))
      << home.log();
  campus.process().signal(SIGUSR1);
  EXPECT_TRUE(logs(campus, "status: upstream talk from 127.0.0.1:")) << campus.log();
}

TEST_F(ServerPush, ANameThatNoStreamHasIsSaidToStandForTheFirst) {
  const std::vector<std::string> streams{stream_file("talk.txt"), stream_file("anger.txt")};
  RunningTransmitter campus(accepting());
  RunningTransmitter home(pushing(address_of(campus, "angre"), streams));
  EXPECT_TRUE(logs(home, "push angre: taken by " + campus.address() +
                             "; it is the first stream, 'talk', as none here is called 'angre'"))
      << home.log();
  RunningTransmitter right(pushing(address_of(campus, "anger"), streams));
  EXPECT_TRUE(logs(right, "push anger: taken by " + campus.address() + "\n")) << right.log();
}

TEST_F(ServerPush, ARecordedStreamIsTheSameBytesThere) {
  const auto talk = folder_.write("talk.txt", "# title: A lecture\n" + text_of("talk.txt"));
  folder_.write("talk.vtt", "WEBVTT\n\n00:00:01.000 --> 00:00:03.000\nGood morning\n");
  RunningTransmitter campus(accepting());
  RunningTransmitter home(pushing(address_of(campus, ""), {talk.string()}));
  ASSERT_TRUE(logs(campus, "talk: it is here whole")) << campus.log() << home.log();
  for (const char* hello : {"{hello v=2 window=64 stream=talk delta=1}", "{hello v=2 window=64}",
                            "{hello v=2 window=64 delta=1 text=1 from=500}"}) {
    EXPECT_EQ(whole(campus, hello), whole(home, hello)) << hello;
  }
  EXPECT_TRUE(logs(home, "has it to its end")) << home.log();
  EXPECT_EQ(home.terminate(), 0);
  EXPECT_TRUE(whole(campus, "{hello v=2 window=64 stream=talk}").ends_with(kEnd)) << "it stays";
}

TEST_F(ServerPush, ARecordingInALoopIsInALoopThere) {
  RunningTransmitter campus(accepting());
  auto arguments = pushing(address_of(campus, "six"), {stream_file("six_expressions.txt")});
  arguments.emplace_back("--loop");
  RunningTransmitter home(arguments);
  ASSERT_TRUE(logs(campus, "six: it is here whole")) << campus.log() << home.log();
  RawClient client = campus.connect();
  const std::string turns = joined(kSixPackets) + joined(kSixPackets);
  ASSERT_TRUE(client.send(std::string(kSixPackets.size() * 2, '1')));
  EXPECT_EQ(client.receive(turns.size()), turns);
}

TEST_F(ServerPush, AClassicClientMayComeBeforeTheStream) {
  RunningTransmitter campus(accepting());
  RawClient client = campus.connect();
  ASSERT_TRUE(client.send("1"));
  RunningTransmitter home(pushing(address_of(campus, "six"), {stream_file("six_expressions.txt")}));
  EXPECT_EQ(client.receive(kSixPackets[0].size()), kSixPackets[0]);
}

TEST_F(ServerPush, WhoWaitsInVainIsTold) {
  RunningTransmitter campus(accepting({"--upstream-wait", "0.2"}));
  EXPECT_TRUE(answer(campus, "{hello v=2 stream=x}").starts_with("{error 503 the stream has not"));
  EXPECT_EQ(answer(campus, "{streams}"), "{streams}");
}

TEST_F(ServerPush, ViewersHoldWhileAKilledPublisherComesBack) {
  RunningTransmitter campus(accepting({"--upstream-wait", "60"}));
  std::optional<RunningTransmitter> home(std::in_place,
                                         pushing(address_of(campus, "talk"), live()));
  ASSERT_TRUE(logs(campus, "talk: live, from")) << campus.log();
  RawClient client = watch(campus, "talk");
  EXPECT_NE(client.receive_until("}"), "");
  home->process().signal(SIGKILL);
  ASSERT_TRUE(logs(campus, "talk: its publisher is gone")) << campus.log();
  home.emplace(pushing(address_of(campus, "talk"), live()));
  ASSERT_TRUE(logs(campus, "talk: goes on with")) << campus.log();
  EXPECT_NE(campus.log().find(" s is missing"), std::string::npos) << campus.log();
  append(webcam_, row(2, "3"));
  const std::string seen = client.receive_until("{12:60;");
  EXPECT_NE(seen.find("{12:60;"), std::string::npos);
  EXPECT_EQ(seen.find(kEnd), std::string::npos);
}

TEST_F(ServerPush, WhenNoPublisherComesTheStreamEndsAndIsForgotten) {
  RunningTransmitter campus(accepting({"--upstream-wait", "0.2"}));
  RunningTransmitter home(pushing(address_of(campus, "talk"), live()));
  ASSERT_TRUE(logs(campus, "talk: live, from")) << campus.log();
  RawClient client = watch(campus, "talk");
  EXPECT_NE(client.receive_until("}"), "");
  home.process().signal(SIGKILL);
  EXPECT_TRUE(client.receive_all().ends_with(kEnd));
  EXPECT_TRUE(logs(campus, "talk: no publisher sends it")) << campus.log();
  EXPECT_EQ(answer(campus, "{streams}"), "{streams}");
}

TEST_F(ServerPush, APublisherComesBackToAKilledServer) {
  const std::string port = free_port();
  std::vector<std::string> arguments{program("au-transmitter"), "--port", port};
  for (const std::string& argument : accepting()) arguments.push_back(argument);
  std::optional<Process> campus(std::in_place, arguments);
  ASSERT_TRUE(campus->read_line(kPatience).has_value()) << campus->err();
  RunningTransmitter home(pushing("aucast://127.0.0.1:" + port + "/talk", live()));
  ASSERT_TRUE(logs(*campus, "talk: live, from")) << campus->err();
  campus->signal(SIGKILL);
  ASSERT_TRUE(campus->wait(kPatience));
  ASSERT_TRUE(logs(home, "cannot be reached")) << home.log();
  campus.emplace(arguments);
  ASSERT_TRUE(campus->read_line(kPatience).has_value()) << campus->err();
  EXPECT_TRUE(logs(*campus, "talk: live, from")) << campus->err();
}

TEST_F(ServerPush, ASecondPublisherIsRefusedAndTakesOverWhenTheFirstIsGone) {
  RunningTransmitter campus(accepting());
  RunningTransmitter first(pushing(address_of(campus, "talk"), live()));
  ASSERT_TRUE(logs(campus, "talk: live, from")) << campus.log();
  RunningTransmitter second(pushing(address_of(campus, "talk"), live()));
  EXPECT_TRUE(logs(second, "the server refused: 409 another publisher sends the stream 'talk'"))
      << second.log();
  EXPECT_TRUE(logs(campus, "refused: 409 another publisher")) << campus.log();
  first.process().signal(SIGKILL);
  EXPECT_TRUE(logs(campus, "talk: goes on with")) << campus.log();
}

TEST_F(ServerPush, TwoNamesOfOneServerDoNotDisplaceEachOther) {
  RunningTransmitter campus(accepting());
  std::vector<std::string> arguments = pushing(address_of(campus, "talk"), live());
  arguments.insert(arguments.begin(), {"--push", "aucast://localhost:" + campus.port() + "/talk"});
  RunningTransmitter home(arguments);
  EXPECT_TRUE(logs(home, "the server refused: 409 another publisher sends the stream 'talk'"))
      << home.log();
  EXPECT_EQ(campus.log().find("takes its place"), std::string::npos) << campus.log();
}

TEST_F(ServerPush, TokensOfPublishersAndViewersAreNotTheSame) {
  const std::string viewers = folder_.write("viewers", "a-word-to-watch-by").string();
  RunningTransmitter campus(accepting({"--token-file", viewers}));
  RunningTransmitter wrong(
      {"--push", address_of(campus, "talk"), "--push-token-file", viewers, webcam_.string()});
  EXPECT_TRUE(logs(wrong, "the server refused: 401 this token lets nobody publish here"))
      << wrong.log();
  RunningTransmitter none({"--push", address_of(campus, "talk"), webcam_.string()});
  EXPECT_TRUE(logs(none, "401 a publisher's token is needed here")) << none.log();
  RunningTransmitter bound(
      {"--push", address_of(campus, "talk"), "--push-token-file", other_, webcam_.string()});
  EXPECT_TRUE(logs(bound, "403 this token is not for the stream 'talk'")) << bound.log();
  EXPECT_TRUE(
      answer(campus, "{hello v=2 token=" + std::string(kToken) + "}").starts_with("{error 401 "));
}

TEST_F(ServerPush, TheServersOwnStreamsAreNobodyElses) {
  RunningTransmitter campus(accepting({stream_file("talk.txt")}));
  RunningTransmitter home(pushing(address_of(campus, "talk"), live()));
  EXPECT_TRUE(logs(home, "409 the stream 'talk' is one of this server's own")) << home.log();
}

TEST_F(ServerPush, AServerThatTakesNoStreamsSaysSo) {
  RunningTransmitter campus({stream_file("talk.txt")});
  RunningTransmitter home(pushing(address_of(campus, "talk"), live()));
  EXPECT_TRUE(logs(home, "the server refused: 403 streams are not taken here (--accept-push)"))
      << home.log();
  EXPECT_TRUE(logs(campus, "refused: 403 streams are not taken here")) << campus.log();
}

TEST_F(ServerPush, AStreamIsNotBroughtBackToWhereItComesFrom) {
  RunningTransmitter campus(accepting());
  RunningTransmitter home(pushing(address_of(campus, "talk"), live()));
  ASSERT_TRUE(logs(campus, "talk: live, from")) << campus.log();
  RunningTransmitter loop(pushing(address_of(campus, "again"), {address_of(campus, "talk")}));
  EXPECT_TRUE(logs(loop, "508 the stream would come back")) << loop.log();
  EXPECT_TRUE(logs(campus, "again: its publisher is gone: the server refused: 508"))
      << campus.log();
}

TEST_F(ServerPush, OverTlsByTheAuthorityThatIsNamed) {
  Authority authority;
  const Certificate own = authority.issue("campus", "DNS:localhost");
  RunningTransmitter campus(accepting({"--tls-cert", own.file, "--tls-key", own.key}));
  const std::string address = "aucasts://localhost:" + campus.port() + "/talk";
  std::vector<std::string> arguments = pushing(address, live());
  RunningTransmitter stranger(arguments);
  EXPECT_TRUE(logs(stranger, "--push-tls-ca FILE names one to believe")) << stranger.log();
  arguments.insert(arguments.begin(), {"--push-tls-ca", authority.file()});
  RunningTransmitter home(arguments);
  EXPECT_TRUE(logs(campus, "talk: live, from")) << campus.log() << home.log();
}

TEST_F(ServerPush, HangupReadsThePublishersAgain) {
  RunningTransmitter campus(accepting());
  const std::string hello = "{hello v=2 publish=x token=a-word-that-is-new}";
  EXPECT_TRUE(answer(campus, hello).starts_with("{error 401 "));
  folder_.write("publishers", "a-word-that-is-new\n");
  campus.process().signal(SIGHUP);
  ASSERT_TRUE(logs(campus, "token were read again")) << campus.log();
  EXPECT_TRUE(answer(campus, hello).starts_with("{hello v=2 window=256 stream=x "));
  folder_.write("publishers", "br{ace\n");
  campus.process().signal(SIGHUP);
  ASSERT_TRUE(logs(campus, "publishers:1: a token is printable")) << campus.log();
  EXPECT_TRUE(answer(campus, hello).starts_with("{hello v=2 window=256 ")) << "as before";
}

TEST_F(ServerPush, AHostilePublisherCostsItsConnection) {
  RunningTransmitter campus(accepting());
  RunningTransmitter home(pushing(address_of(campus, "talk"), live()));
  ASSERT_TRUE(logs(campus, "talk: live, from")) << campus.log();
  RawClient client = watch(campus, "talk");
  const std::string hello = "{hello v=2 token=" + std::string(kToken) + " publish=bad}";
  const std::string live_hello = "{hello v=2 window=50 delta=1 stream=bad live=1}";
  for (const auto& [bytes, reason] : std::vector<std::pair<std::string, std::string>>{
           {"GET / HTTP/1.1\r\n", "what is not the protocol"},
           {live_hello + std::string(100'000, '{'), "what is not the protocol"},
           {live_hello + "{1" + std::string(100'000, ' '), "no closing brace within 4096 bytes"},
           {"{hello v=2 window=50 stream=other live=1}", "it sends the stream 'other'"},
           {"{1,6}", "it speaks classic only"},
           {"{hello v=2 window=50 stream=bad}", "does not say how long its stream"},
           {live_hello +
                [] {
                  std::string flood;
                  for (int i = 0; i < 3000; ++i) flood += "{1}";
                  return flood;
                }(),
            "it sends more than 2000 keyframes, voice packets and captions a second"}}) {
    std::string reply;
    RawClient bad = say_hello(campus, hello, reply);
    ASSERT_TRUE(reply.starts_with("{hello v=2 window=256 stream=bad ")) << reply;
    bad.send(bytes);
    static_cast<void>(bad.receive_all());
    EXPECT_TRUE(logs(campus, reason)) << reason << "\n" << campus.log();
  }
  EXPECT_TRUE(
      answer(campus, "{hello publish=" + std::string(65, 'x') + "}").starts_with("{error 400 "));
  EXPECT_TRUE(
      answer(campus, "{hello publish=" + std::string(9000, 'x')).starts_with("{error 400 "));
  append(webcam_, row(2, "3"));
  EXPECT_NE(client.receive_until("{12:60;").find("{12:60;"), std::string::npos);
}

TEST_F(ServerPush, OptionsThatCannotBeRightAreSaidAtTheStart) {
  const auto said = [](const std::vector<std::string>& arguments) {
    std::vector<std::string> all{program("au-transmitter"), "--port", "0"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    Finished finished = run(all);
    return std::to_string(finished.exit_code) + " " + finished.err;
  };
  const std::string talk = stream_file("talk.txt");
  EXPECT_TRUE(said({"--push", "campus", talk}).starts_with("2 au-transmitter: 'campus' is no"));
  EXPECT_TRUE(said(accepting({"--push", "aucast://a/b"})).starts_with("2 "));
  EXPECT_NE(said(pushing("aucast://example.org/x", {talk})).find("use aucasts://"),
            std::string::npos);
  EXPECT_TRUE(said({"--accept-push", "/nowhere"}).starts_with("4 "));
  EXPECT_TRUE(said(accepting({"--token-file", token_})).starts_with("3 "));
  const auto bad = folder_.write("bad", "word talk/1\n");
  EXPECT_TRUE(said({"--accept-push", bad.string(), "--check"}).starts_with("3 "));
  EXPECT_TRUE(
      said(pushing("aucasts://example.org/x", {"--push-tls-ca", bad.string(), "--check", talk}))
          .starts_with("3 "));
}

TEST_F(ServerPush, CheckSaysWhoMayPublish) {
  const Finished finished =
      run({program("au-transmitter"), "--check", "--accept-push", publishers_.string()});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_NE(finished.out.find("2 publishers, 1 of them for any stream"), std::string::npos)
      << finished.out;
}

}  // namespace
}  // namespace aucast::test
