// Both programs over a bad link, and when one of them is killed, stopped or has no room to write.
// Times are short; $AUCAST_FAULT_SECONDS (1) says how long what goes wrong lasts, and
// scripts/faults runs the same at full length and over the link emulator.
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/integration/server_running.h"
#include "tests/support/eventually.h"
#include "tests/support/fault_proxy.h"
#include "tests/support/seeded.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

using namespace std::chrono_literals;
using std::chrono::seconds;

/// How long a link is down or a program stopped.
seconds fault_time() {
  const char* text = std::getenv("AUCAST_FAULT_SECONDS");
  return seconds(text == nullptr ? 1 : std::max(1, std::atoi(text)));
}

/// A talking, looking, nodding face: `count` keyframes of 40 ms with intensities, head (51-58) and
/// gaze (61-64) that move all the time.
std::string lively(int count) {
  std::string text = "Beg_Stream\n";
  for (int n = 0; n < count; ++n) {
    const auto percent = [n](int step) { return std::to_string(10 + n * step % 90); };
    text += "1:" + percent(1) + ",L12:" + percent(7) + ",R12:" + percent(5) + ",25:" + percent(13) +
            "," + (n / 50 % 2 == 0 ? "51:" : "52:") + percent(3) + ",54:" + percent(2) + "," +
            (n / 30 % 2 == 0 ? "61:" : "62:") + percent(11) + ";40\n";
  }
  return text + "End_Stream\n";
}

class Faults : public ::testing::Test {
 protected:
  /// Starts a player that writes its statistics; `name` tells them apart.
  std::unique_ptr<Process> player(const std::string& address, const std::string& name,
                                  std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{program("face-player"), "--headless", address, "--stats",
                                       folder_.path() / (name + ".json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return std::make_unique<Process>(arguments);
  }

  nlohmann::json stats(const std::string& name) const {
    const std::string text = folder_.read(name + ".json");
    return text.empty() ? nlohmann::json() : nlohmann::json::parse(text);
  }

  void expect_whole(Process& process, const std::string& name, int keyframes) {
    EXPECT_EQ(process.wait(patience()), 0) << process.err();
    EXPECT_EQ(stats(name)["keyframes_played"], keyframes) << stats(name);
    EXPECT_EQ(stats(name)["end_reason"], "end_of_stream");
  }

  /// Whatever the machine is busy with, so much of the stream is under way then.
  static void wait_for_bytes(const FaultProxy& link, std::int64_t bytes) {
    EXPECT_TRUE(eventually([&] { return link.bytes_to_clients() >= bytes; }, 3 * kPatience));
  }

  static seconds patience() { return 60s + 3 * fault_time(); }

  const TempFolder folder_;
};

TEST_F(Faults, LongThinLinkPlaysWithoutAStall) {
  RunningTransmitter server({folder_.write("lively.txt", lively(70))});
  FaultProxy link(server.address(), {300ms, 50ms, 64}, Seeded().seed());
  auto playing = player(link.address(), "long");
  expect_whole(*playing, "long", 70);
  EXPECT_EQ(stats("long")["stalls"], 0) << stats("long");
  EXPECT_EQ(stats("long")["protocol_level"], 2);
}

TEST_F(Faults, LinkThatGoesDownLosesNothingOfARecordedStream) {
  RunningTransmitter server({folder_.write("lively.txt", lively(75))});
  FaultProxy link(server.address(), {}, 1);
  auto playing = player(link.address(), "down", {"--buffer", "10", "--playout", "5"});
  wait_for_bytes(link, 1000);
  link.set_down(true);
  std::this_thread::sleep_for(fault_time());
  EXPECT_FALSE(playing->wait(0ms).has_value()) << "it holds the face: " << playing->err();
  link.set_down(false);
  expect_whole(*playing, "down", 75);
}

TEST_F(Faults, LinkThatGoesDownLetsALiveStreamGoOnWhereItIs) {
  const int count = 60 + 25 * static_cast<int>(fault_time().count());
  RunningTransmitter server({"--live", folder_.write("lively.txt", lively(count))});
  FaultProxy link(server.address(), {}, 1);
  auto playing = player(link.address(), "live");
  wait_for_bytes(link, 1000);
  link.set_down(true);
  std::this_thread::sleep_for(fault_time());
  link.set_down(false);
  EXPECT_EQ(playing->wait(patience()), 0) << playing->err();
  EXPECT_EQ(stats("live")["end_reason"], "end_of_stream");
  EXPECT_TRUE(stats("live")["live"]);
  EXPECT_GT(stats("live")["keyframes_played"], 20);
}

TEST_F(Faults, KilledServerIsFoundAgain) {
  const std::string file = folder_.write("lively.txt", lively(75));
  auto first = std::make_unique<RunningTransmitter>(std::vector<std::string>{"--live", file});
  const std::string address = first->address();
  FaultProxy link(address, {}, 1);
  auto playing = player(link.address(), "killed", {"--reconnect"});
  wait_for_bytes(link, 500);
  first->process().signal(SIGKILL);
  EXPECT_EQ(first->process().wait(kPatience), 128 + SIGKILL);
  std::this_thread::sleep_for(fault_time());
  EXPECT_FALSE(playing->wait(0ms).has_value()) << playing->err();
  Process second({program("au-transmitter"), "--live", "--port", first->port(), file});
  EXPECT_EQ(playing->wait(patience()), 0) << playing->err();
  EXPECT_EQ(stats("killed")["end_reason"], "end_of_stream");
  EXPECT_GE(stats("killed")["reconnects"], 1);
}

TEST_F(Faults, KilledServerWithoutReconnectIsALossToThePlayer) {
  RunningTransmitter server({folder_.write("lively.txt", lively(500))});
  FaultProxy link(server.address(), {}, 1);
  auto playing = player(link.address(), "lost", {"--buffer", "10", "--playout", "5"});
  wait_for_bytes(link, 200);
  server.process().signal(SIGKILL);
  EXPECT_EQ(playing->wait(patience()), 5) << playing->err();
  EXPECT_EQ(stats("lost")["end_reason"], "connection_lost");
}

TEST_F(Faults, KilledClientIsNobodyElsesBusiness) {
  RunningTransmitter server({"--live", folder_.write("lively.txt", lively(60))});
  auto other = player(server.address(), "other");
  FaultProxy link(server.address(), {}, 1);
  auto killed = player(link.address(), "killed");
  EXPECT_TRUE(logs(server, ": connected", 2)) << server.log();
  wait_for_bytes(link, 500);
  killed->signal(SIGKILL);
  EXPECT_EQ(killed->wait(kPatience), 128 + SIGKILL);
  EXPECT_EQ(other->wait(patience()), 0) << other->err();
  EXPECT_EQ(stats("other")["end_reason"], "end_of_stream") << stats("other");
  EXPECT_EQ(stats("other")["reconnects"], 0);
  EXPECT_EQ(server.terminate(), 0);
  EXPECT_NE(server.log().find("closed: peer gone"), std::string::npos) << server.log();
}

TEST_F(Faults, StoppedServerIsWaitedFor) {
  RunningTransmitter server({folder_.write("lively.txt", lively(150))});
  FaultProxy link(server.address(), {}, 1);
  auto playing = player(link.address(), "stopped", {"--buffer", "10", "--playout", "5"});
  wait_for_bytes(link, 1000);
  server.process().signal(SIGSTOP);
  std::this_thread::sleep_for(fault_time());
  server.process().signal(SIGCONT);
  expect_whole(*playing, "stopped", 150);
  EXPECT_GE(stats("stopped")["stalls"], 1) << stats("stopped");
}

TEST_F(Faults, StoppedClientPlaysOnAndDisturbsNobody) {
  const int count = 60 + 25 * static_cast<int>(fault_time().count());
  RunningTransmitter server({"--live", folder_.write("lively.txt", lively(count))});
  FaultProxy other_link(server.address(), {}, 1);
  auto other = player(other_link.address(), "other");
  FaultProxy link(server.address(), {}, 2);
  auto stopped = player(link.address(), "stopped");
  EXPECT_TRUE(logs(server, ": connected", 2)) << server.log();
  wait_for_bytes(link, 500);
  stopped->signal(SIGSTOP);
  const std::int64_t before = other_link.bytes_to_clients();
  std::this_thread::sleep_for(fault_time());
  EXPECT_GT(other_link.bytes_to_clients(), before) << "the other one goes on meanwhile";
  const std::int64_t at_most = link.bytes_to_clients();
  stopped->signal(SIGCONT);
  EXPECT_TRUE(eventually([&] { return link.bytes_to_clients() > at_most; })) << "it is sent more";
  EXPECT_EQ(stopped->wait(patience()), 0) << stopped->err();
  EXPECT_EQ(stats("stopped")["end_reason"], "end_of_stream");
  EXPECT_EQ(stats("stopped")["reconnects"], 0) << "it was not cut off";
  EXPECT_EQ(other->wait(patience()), 0) << other->err();
  EXPECT_EQ(stats("other")["end_reason"], "end_of_stream") << stats("other");
  EXPECT_EQ(stats("other")["reconnects"], 0);
}

TEST_F(Faults, FullDiskOfTheStatisticsIsSaid) {
  RunningTransmitter server({"--stats", "/dev/full", stream_file("six_expressions.txt")});
  auto playing = player(server.address(), "good");
  EXPECT_EQ(playing->wait(patience()), 0) << playing->err();
  EXPECT_EQ(server.terminate(), 1);
  EXPECT_NE(server.log().find("/dev/full"), std::string::npos) << server.log();
}

}  // namespace
}  // namespace aucast::test
