// face-player --live with a source that is being written. How long it takes is for
// scripts/live_delay.py to say; here it is whether it is all there, in order, and told.
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/integration/player_run.h"
#include "tests/integration/server_running.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

using namespace std::chrono_literals;

/// The intensities of AU 1 that the log says were reached, in its order.
std::vector<int> reached(const std::string& log) {
  constexpr std::string_view kBefore = "reached {1:";
  std::vector<int> percents;
  for (auto at = log.find(kBefore); at != std::string::npos; at = log.find(kBefore, at + 1)) {
    percents.push_back(std::atoi(log.c_str() + at + kBefore.size()));
  }
  return percents;
}

TEST(PlayerLive, ReachesTheRowsOfAFifoInTheirOrder) {
  const TempFolder folder;
  const auto fifo = folder.path() / "face.fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  RunningTransmitter server({"--dead-band", "0", "--source-timeout", "1", fifo.string()});
  Process player({program("face-player"), "--headless", "--live", "--log-level", "trace", "--stats",
                  folder.path() / "stats.json", server.address()});
  constexpr int kRows = 75;
  {
    std::ofstream rows(fifo);
    rows << "face_id,timestamp,success,AU01_r\n";
    // Rows of 40 ms; each has an intensity of its own, 10 to 84 %.
    for (int row = 0; row < kRows; ++row) {
      rows << "0," << 0.04 * row << ",1," << 0.05 * (10 + row) << std::endl;
      std::this_thread::sleep_for(40ms);
    }
  }
  EXPECT_EQ(player.wait(kPatience), 0) << player.err();
  const std::vector<int> rows = reached(player.err());
  ASSERT_GT(rows.size(), 10U) << player.err();
  // Then the source is silent and the face goes to neutral.
  const auto end = std::find(rows.begin(), rows.end(), 9 + kRows);
  ASSERT_NE(end, rows.end()) << "the last row is always reached";
  for (auto row = rows.begin(); row != end; ++row) EXPECT_LT(*row, *(row + 1));

  const auto stats = nlohmann::json::parse(folder.read("stats.json"));
  EXPECT_EQ(stats["end_reason"], "end_of_stream");
  EXPECT_TRUE(stats["live"]);
  // How long exactly is LivePlayout's test's: here a busy machine has its say.
  EXPECT_GT(stats["live_delay_target_ms"], 0);
  EXPECT_GE(stats["live_delay_p50_ms"], stats["live_delay_target_ms"]) << "no face is early";
  EXPECT_GE(stats["live_delay_max_ms"], stats["live_delay_p50_ms"]);
  EXPECT_EQ(player.err().find("changes nothing"), std::string::npos);
}

TEST(PlayerLive, SaysWhereItChangesNothing) {
  RunningTransmitter server({stream_file("happiness.txt")});
  const std::vector<std::pair<std::vector<std::string>, std::string>> kCases{
      {{"--headless", "--live", server.address()}, "is recorded, not live"},
      {{"--headless", "--live", "--protocol", "classic", server.address()}, "a classic server"},
      {{"play", "--headless", "--live", stream_file("happiness.txt")}, "a file is not live"}};
  for (const auto& [arguments, words] : kCases) {
    const PlayerRun run = run_player(arguments);
    EXPECT_EQ(run.finished.exit_code, 0) << run.finished.err;
    EXPECT_NE(run.finished.err.find(words), std::string::npos) << run.finished.err;
    EXPECT_EQ(run.stats["live"], false);
    EXPECT_EQ(run.stats["live_delay_p50_ms"], nullptr);
  }
}

}  // namespace
}  // namespace aucast::test
