// The real face-player against servers that are strict, careless or hostile.

#include <gtest/gtest.h>

#include "tests/integration/player_run.h"
#include "tests/support/scripted_server.h"
#include "tests/support/served.h"

namespace aucast::test {
namespace {

PlayerRun watch(ScriptedServer& server, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{"--headless", "127.0.0.1:" + std::to_string(server.port()),
                                     "--fast"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  PlayerRun run = run_player(std::move(arguments));
  EXPECT_EQ(server.finish(), "");
  return run;
}

void expect_network_failure(const PlayerRun& run, const std::string& end_reason,
                            const std::string& word) {
  EXPECT_EQ(run.finished.exit_code, 5);
  EXPECT_EQ(run.stats["end_reason"], end_reason) << run.finished.err;
  EXPECT_NE(run.finished.err.find(word), std::string::npos) << run.finished.err;
  EXPECT_EQ(std::count(run.finished.err.begin(), run.finished.err.end(), '\n'), 1);
}

TEST(PlayerNetwork, AStrictClassicServer) {
  ScriptedServer server({Accept{}, Send{"{1,2,5}"}, Expect{"1"}, Send{"{6,12}", 1}, Expect{"1"},
                         Send{"{-2}"}, HalfClose{}, ExpectEnd{}});
  const PlayerRun run = watch(server, {"--protocol", "classic"});
  EXPECT_EQ(run.finished.exit_code, 0) << run.finished.err;
  EXPECT_EQ(run.stats["keyframes_played"], 2);
  EXPECT_EQ(run.stats["bytes_received"], 13);
}

TEST(PlayerNetwork, AClassicServerThatTakesTheHelloForGarbage) {
  ScriptedServer server({Accept{}, ExpectHello{}, Send{"{1,2,5}"}, Close{}, Accept{},
                         Send{"{1,2,5}"}, Expect{"1"}, Send{"{6,12}"}, Expect{"1"}, Send{"{-2}"},
                         HalfClose{}, ExpectEnd{}});
  const PlayerRun run = watch(server);
  EXPECT_EQ(run.finished.exit_code, 0) << run.finished.err;
  EXPECT_EQ(run.stats["keyframes_played"], 2);
  EXPECT_EQ(run.stats["protocol_level"], 1);
}

TEST(PlayerNetwork, EndAsTheFirstPacketIsAProperEnd) {
  ScriptedServer server({Accept{}, Send{"{-2}"}, HalfClose{}, ExpectEnd{}});
  const PlayerRun run = watch(server, {"--protocol", "classic"});
  EXPECT_EQ(run.finished.exit_code, 0) << run.finished.err;
  EXPECT_EQ(run.stats["keyframes_played"], 0);
  EXPECT_EQ(run.stats["end_reason"], "end_of_stream");
}

TEST(PlayerNetwork, ClosedInTheMiddleOfAPacket) {
  ScriptedServer server({Accept{}, Send{"{1,2}"}, Expect{"1"}, Send{"{6,1"}, Close{}});
  const PlayerRun run = watch(server, {"--protocol", "classic"});
  expect_network_failure(run, "connection_lost", "127.0.0.1");
  EXPECT_EQ(run.stats["keyframes_played"], 1);
}

TEST(PlayerNetwork, GarbageIsShownEscaped) {
  ScriptedServer server({Accept{}, Send{"{1}"}, Expect{"1"}, Send{"\x1b[2J"}, ExpectEnd{}});
  const PlayerRun run = watch(server, {"--protocol", "classic"});
  expect_network_failure(run, "protocol_error", "byte 3");
  EXPECT_EQ(run.finished.err.find('\x1b'), std::string::npos);
}

TEST(PlayerNetwork, TenMegabytesWithoutABrace) {
  const std::string digits(std::size_t{10} << 20U, '1');
  ScriptedServer server({Accept{}, Send{"{" + digits}, ExpectEnd{}});
  expect_network_failure(watch(server, {"--protocol", "classic"}), "protocol_error", "127.0.0.1");
}

TEST(PlayerNetwork, ManyNumbersWithoutAClosingBrace) {
  std::string numbers = "{1";
  while (numbers.size() < 10000) numbers += ",2";
  ScriptedServer server({Accept{}, Send{numbers}, ExpectEnd{}});
  expect_network_failure(watch(server, {"--protocol", "classic"}), "protocol_error", "4096");
}

TEST(PlayerNetwork, NothingAtAll) {
  ScriptedServer server({Accept{}, ExpectEnd{}});
  expect_network_failure(watch(server, {"--protocol", "classic", "--connect-timeout", "0.3"}),
                         "unreachable", "nothing came");
}

TEST(PlayerNetwork, GoesOnWhereItWasCutOff) {
  ScriptedServer server({Accept{}, ExpectHello{},
                         Send{"{hello v=2 window=4 keyframe=20}{1}{2;30}{6,1"}, Close{}, Accept{},
                         ExpectHello{}, Send{"{hello v=2 window=4 keyframe=20 from=50}{6,12}{-2}"},
                         HalfClose{}, ExpectEnd{}});
  const PlayerRun run = watch(server, {"--reconnect"});
  EXPECT_EQ(run.finished.exit_code, 0) << run.finished.err;
  EXPECT_EQ(run.stats["keyframes_played"], 3);
  EXPECT_EQ(run.stats["reconnects"], 1);
  EXPECT_NE(server.received().find("from=50}"), std::string::npos) << server.received();
}

/// What the player says of a connection that is lost twice.
void expect_two_losses_told(const std::vector<std::string>& more) {
  const std::string hello = "{hello v=2 window=4 keyframe=20}";
  ScriptedServer server({Accept{}, ExpectHello{}, Send{hello + "{1}"}, Close{}, Accept{},
                         ExpectHello{}, Send{hello + "{2;30}"}, Close{}, Accept{}, ExpectHello{},
                         Send{hello + "{6,1}{-2}"}, HalfClose{}, ExpectEnd{}});
  std::vector<std::string> arguments{"--headless", "127.0.0.1:" + std::to_string(server.port()),
                                     "--reconnect"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const PlayerRun run = run_player(std::move(arguments));
  EXPECT_EQ(server.finish(), "");
  EXPECT_EQ(run.finished.exit_code, 0) << run.finished.err;
  EXPECT_EQ(run.stats["reconnects"], 2);
  std::size_t told = 0;
  for (std::size_t at = 0; (at = run.finished.err.find("again in", at)) != std::string::npos;
       ++at) {
    ++told;
  }
  EXPECT_EQ(told, 2U) << run.finished.err;
}

TEST(PlayerNetwork, SaysOfEveryLossThatThereIsNoConnection) {
  expect_two_losses_told({});
}

TEST(PlayerNetwork, SaysOfEveryLossInARunOnTheVideoClockToo) {
  expect_two_losses_told({"--fast"});
}

TEST(PlayerList, PrintsTheNamesOfTheStreams) {
  Served served({stream_file("happiness.txt"), stream_file("anger.txt")});
  const Finished list = run({program("face-player"), "--list", served.address()});
  EXPECT_EQ(list.exit_code, 0) << list.err;
  EXPECT_EQ(list.out, "happiness\nanger\n");
  EXPECT_EQ(list.err, "");
}

TEST(PlayerList, FailuresHaveTheUsualCodes) {
  const Finished refused = run({program("face-player"), "--list", "127.0.0.1:1"});
  EXPECT_EQ(refused.exit_code, 5);
  EXPECT_EQ(refused.out, "");
  EXPECT_NE(refused.err.find("127.0.0.1:1: cannot be reached"), std::string::npos) << refused.err;
  EXPECT_EQ(run({program("face-player"), "--list"}).exit_code, 2);
}

}  // namespace
}  // namespace aucast::test
