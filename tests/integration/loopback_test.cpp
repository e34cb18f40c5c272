// Both real programs over a real socket.

#include <csignal>
#include <map>

#include <gtest/gtest.h>

#include "tests/integration/player_run.h"
#include "tests/support/relay.h"
#include "tests/support/seeded.h"
#include "tests/support/served.h"

namespace aucast::test {
namespace {

using namespace std::chrono_literals;

TEST(Loopback, SixExpressionsArriveWhole) {
  Served served({stream_file("six_expressions.txt")});
  ASSERT_NE(served.address(), "") << served.process().err();
  const PlayerRun run = run_player({"--headless", served.address(), "--fast"});
  EXPECT_EQ(run.finished.exit_code, 0) << run.finished.err;
  EXPECT_EQ(run.finished.err, "");
  EXPECT_EQ(run.stats["packets_received"], 6);
  EXPECT_EQ(run.stats["bytes_received"], 19 + 18 + 13 + 18 + 11 + 11);
  EXPECT_EQ(run.stats["keyframes_played"], 6);
  EXPECT_EQ(run.stats["frames"], 300);
  EXPECT_EQ(run.stats["frames_drawn"], 0);
  EXPECT_DOUBLE_EQ(run.stats["media_seconds"].get<double>(), 1.5);
  EXPECT_EQ(run.stats["protocol_level"], 2);
  EXPECT_EQ(run.stats["end_reason"], "end_of_stream");
}

TEST(Loopback, BytesOfEachExpressionAreThoseOfTable55) {
  const std::map<std::string, int> bytes{{"surprise", 19}, {"fear", 18},      {"disgust", 13},
                                         {"anger", 18},    {"happiness", 11}, {"sadness", 11}};
  for (const auto& [name, expected] : bytes) {
    Served served({stream_file(name + ".txt")});
    ASSERT_NE(served.address(), "") << served.process().err();
    const PlayerRun run =
        run_player({"--headless", served.address(), "--fast", "--protocol", "classic"});
    EXPECT_EQ(run.finished.exit_code, 0) << run.finished.err;
    EXPECT_EQ(run.stats["packets_received"], 1) << name;
    EXPECT_EQ(run.stats["bytes_received"], expected) << name;
    EXPECT_EQ(run.stats["protocol_level"], 1) << name;
  }
}

TEST(Loopback, RealTimePlaysEveryPositionOnce) {
  Served served({stream_file("six_expressions.txt")});
  const PlayerRun run = run_player({"--headless", served.address(), "--speed", "50"});
  EXPECT_EQ(run.finished.exit_code, 0) << run.finished.err;
  EXPECT_EQ(run.stats["frames"], 300);
  EXPECT_EQ(run.stats["stalls"], 0);
  EXPECT_DOUBLE_EQ(run.stats["media_seconds"].get<double>(), 0.3);
  // Measured on the clock, so never less than the media; how much more is the machine's business.
  EXPECT_GE(run.stats["playback_seconds"].get<double>(), 0.3);
}

TEST(Loopback, SmallestBuffersPauseAndLoseNothing) {
  Served served({stream_file("random.txt")});
  ASSERT_NE(served.address(), "") << served.process().err();
  for (const char* protocol : {"auto", "classic"}) {
    const PlayerRun run = run_player({"--headless", served.address(), "--buffer", "2", "--playout",
                                      "1", "--speed", "5", "--protocol", protocol});
    EXPECT_EQ(run.finished.exit_code, 0) << run.finished.err;
    EXPECT_EQ(run.stats["keyframes_played"], run.stats["packets_received"]) << protocol;
    EXPECT_EQ(run.stats["pauses_sent"], run.stats["resumes_sent"]) << protocol;
    EXPECT_GT(run.stats["pauses_sent"].get<int>(), 0) << protocol;
  }
}

TEST(Loopback, NetcatIsAClient) {
  Served served({stream_file("six_expressions.txt")});
  const std::string host_and_port = "127.0.0.1 " + served.address().substr(10);
  const Finished done = run({"sh", "-c", "printf 1111111 | nc " + host_and_port});
  EXPECT_EQ(done.out,
            "{1,2,5,15,16,20,26}{1,2,4,5,15,20,26}{2,4,9,15,17}{2,4,7,9,10,20,26}{1,6,12,14}"
            "{1,4,15,23}{-2}")
      << done.err;
}

TEST(Loopback, ManyPlayersGetTheSame) {
  Served served({stream_file("six_expressions.txt"), stream_file("happiness.txt")});
  std::vector<std::unique_ptr<Process>> players;
  for (int i = 0; i < 8; ++i) {
    players.push_back(std::make_unique<Process>(
        std::vector<std::string>{program("face-player"), "--headless", served.address(), "--fast",
                                 "--stats", i % 2 == 0 ? "-" : "/dev/stdout"}));
  }
  for (auto& player : players) {
    ASSERT_EQ(player->wait(60s), 0) << player->err();
    EXPECT_EQ(nlohmann::json::parse(player->out())["bytes_received"], 90);
  }
  const PlayerRun named =
      run_player({"--headless", served.address(), "--fast", "--stream", "happiness"});
  EXPECT_EQ(named.stats["bytes_received"], 11);
}

TEST(Loopback, ARelayThatCutsAndJoinsBytesChangesNothing) {
  Served served({stream_file("six_expressions.txt"), stream_file("talk.txt")});
  const Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (const char* protocol : {"auto", "classic"}) {
    for (const char* stream : {"six_expressions", "talk"}) {
      const bool named = std::string(protocol) == "auto";
      if (!named && std::string(stream) == "talk") continue;  // classic gets the first stream only
      std::vector<std::string> arguments{"--headless", served.address(), "--fast", "--protocol",
                                         protocol};
      if (named) arguments.insert(arguments.end(), {"--stream", stream});
      const PlayerRun direct = run_player(arguments);
      const Relay relay(served.address(), seeded.seed());
      arguments[1] = relay.address();
      const PlayerRun relayed = run_player(arguments);
      EXPECT_EQ(relayed.finished.exit_code, 0) << relayed.finished.err;
      for (const char* field : {"packets_received", "bytes_received", "keyframes_played",
                                "media_seconds", "protocol_level", "end_reason"}) {
        EXPECT_EQ(relayed.stats[field], direct.stats[field]) << protocol << stream << field;
      }
    }
  }
}

TEST(Loopback, AnUnknownStreamIsRefusedWithItsName) {
  Served served({stream_file("six_expressions.txt")});
  const PlayerRun run =
      run_player({"--headless", served.address(), "--fast", "--stream", "lecture"});
  EXPECT_EQ(run.finished.exit_code, 5);
  EXPECT_EQ(run.stats["end_reason"], "refused");
  EXPECT_NE(run.finished.err.find("404"), std::string::npos) << run.finished.err;
}

TEST(Loopback, InterruptSendsStopAndFinishesTheFiles) {
  Served served({stream_file("six_expressions.txt"), "--loop"});
  const TempFolder folder;
  const auto stats = folder.path() / "stats.json";
  Process player({program("face-player"), "--headless", served.address(), "--log-level", "info",
                  "--speed", "10", "--stats", stats.string()});
  ASSERT_FALSE(player.wait(1500ms).has_value()) << player.err();
  player.signal(SIGINT);
  EXPECT_EQ(player.wait(20s), 0) << player.err();
  const auto json = nlohmann::json::parse(folder.read("stats.json"));
  EXPECT_EQ(json["end_reason"], "stopped");
  EXPECT_GT(json["keyframes_played"].get<int>(), 0);
}

TEST(Loopback, ALiveStreamIsPlayedFromNowToItsEnd) {
  const TempFolder folder;
  std::string text = "Beg_Stream\n";
  for (int n = 1; n <= 100; ++n) text += "1:" + std::to_string(n) + ",6,12;20\n";
  const auto file = folder.write("count.txt", text + "End_Stream\n");
  Served served({"--live", file.string()});
  const PlayerRun run = run_player({"--headless", served.address()});
  EXPECT_EQ(run.finished.exit_code, 0) << run.finished.err;
  EXPECT_EQ(run.stats["live"], true);
  EXPECT_EQ(run.stats["end_reason"], "end_of_stream");
  EXPECT_EQ(run.stats["packets_received"].get<int>(),
            run.stats["keyframes_played"].get<int>() + run.stats["keyframes_dropped"].get<int>());
  EXPECT_EQ(run.stats["pauses_sent"], 0);
}

/// Not before it plays: however slow this machine is, it has met its server then.
void wait_until_it_plays(Process& player) {
  for (int tenth = 0; player.err().find("playing") == std::string::npos; ++tenth) {
    ASSERT_FALSE(player.wait(100ms).has_value()) << player.err();
    ASSERT_LT(tenth, 600) << player.err();
  }
}

TEST(Loopback, NothingIsLostWhenAServerLeavesItsClientsToAnother) {
  const TempFolder folder;
  std::string text = "Beg_Stream\n";
  for (int n = 1; n <= 200; ++n) text += "1:" + std::to_string(n % 100 + 1) + ",6,12;20\n";
  const auto file = folder.write("count.txt", text + "End_Stream\n").string();
  Served first({"--drain-time", "0.1", file});
  Process player({program("face-player"), "--headless", "--reconnect", "-v", first.address(),
                  "--stats", (folder.path() / "stats.json").string()});
  wait_until_it_plays(player);
  first.process().signal(SIGTERM);
  EXPECT_EQ(first.process().wait(20s), 0);
  Process second({program("au-transmitter"), "--port",
                  first.address().substr(first.address().rfind(':') + 1), file});
  ASSERT_TRUE(second.read_line(20s).has_value()) << second.err();
  EXPECT_EQ(player.wait(40s), 0) << player.err();
  const auto json = nlohmann::json::parse(folder.read("stats.json"));
  EXPECT_EQ(json["end_reason"], "end_of_stream");
  EXPECT_GE(json["reconnects"], 1);
  EXPECT_EQ(json["keyframes_played"], 200) << "each once";
}

TEST(Loopback, ReconnectOutlivesAServer) {
  const TempFolder folder;
  auto first = std::make_unique<Served>(
      std::vector<std::string>{"--live", "--loop", stream_file("talk.txt")});
  const std::string address = first->address();
  Process player({program("face-player"), "--headless", "--reconnect", "-v", address, "--stats",
                  (folder.path() / "stats.json").string()});
  wait_until_it_plays(player);
  first->process().signal(SIGKILL);
  ASSERT_TRUE(first->process().wait(20s).has_value());
  Process second({program("au-transmitter"), "--port", address.substr(address.rfind(':') + 1),
                  stream_file("happiness.txt")});
  ASSERT_TRUE(second.read_line(20s).has_value()) << second.err();
  EXPECT_EQ(player.wait(40s), 0) << player.err();
  const auto json = nlohmann::json::parse(folder.read("stats.json"));
  EXPECT_EQ(json["end_reason"], "end_of_stream");
  EXPECT_GE(json["reconnects"].get<int>(), 1);
}

TEST(Loopback, AServerThatIsKilledIsAConnectionLost) {
  Served served({stream_file("six_expressions.txt"), "--loop"});
  const TempFolder folder;
  Process player({program("face-player"), "--headless", served.address(), "--speed", "10",
                  "--stats", (folder.path() / "stats.json").string()});
  ASSERT_FALSE(player.wait(1500ms).has_value()) << player.err();
  served.process().signal(SIGKILL);
  EXPECT_EQ(player.wait(20s), 5) << player.err();
  EXPECT_EQ(nlohmann::json::parse(folder.read("stats.json"))["end_reason"], "connection_lost");
}

}  // namespace
}  // namespace aucast::test
