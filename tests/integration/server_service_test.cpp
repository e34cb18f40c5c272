// au-transmitter as an operator keeps it: signals, reloads, logs.
#include <cstdlib>
#include <regex>
#include <sstream>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/integration/server_running.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

using namespace std::chrono_literals;

class ServerReload : public ::testing::Test {
 protected:
  std::string write(const std::string& packets) {
    return folder_.write("face.txt", "Beg_Stream\n" + packets + "End_Stream\n").string();
  }

  TempFolder folder_;
};

TEST_F(ServerReload, NewClientsGetTheNewStreamOthersKeepTheirs) {
  RunningTransmitter server({write("1\n2\n3\n")});
  RawClient before = server.connect();
  EXPECT_EQ(before.receive_until("}"), "{1}");
  static_cast<void>(write("11\n12\n"));
  server.process().signal(SIGHUP);
  ASSERT_TRUE(logs(server, "for the 1 client here nothing changes")) << server.log();
  RawClient after = server.connect();
  after.send("11");
  EXPECT_EQ(after.receive_all(), "{11}{12}{-2}");
  before.send("111");
  EXPECT_EQ(before.receive_all(), "{2}{3}{-2}");
  EXPECT_EQ(server.terminate(), 0);
}

TEST_F(ServerReload, BrokenFilesChangeNothingAndAreSaid) {
  const std::string file = write("1\n");
  RunningTransmitter server({file});
  static_cast<void>(write("1\nnonsense\n1,,2\n"));
  server.process().signal(SIGHUP);
  ASSERT_TRUE(logs(server, "what was served before is served on")) << server.log();
  EXPECT_NE(server.log().find("error au-transmitter: " + file + ":3:1: "), std::string::npos);
  EXPECT_NE(server.log().find("error au-transmitter: " + file + ":4:3: "), std::string::npos)
      << server.log();
  RawClient client = server.connect();
  client.send("1");
  EXPECT_EQ(client.receive_all(), "{1}{-2}");
  static_cast<void>(write("5\n"));
  server.process().signal(SIGHUP);
  ASSERT_TRUE(logs(server, "serving 1 stream now"));
  RawClient repaired = server.connect();
  repaired.send("1");
  EXPECT_EQ(repaired.receive_all(), "{5}{-2}");
  EXPECT_EQ(server.terminate(), 0);
}

TEST_F(ServerReload, FolderIsLookedThroughAgain) {
  static_cast<void>(write("1\n"));
  RunningTransmitter server({folder_.path()});
  std::string reply;
  static_cast<void>(say_hello(server, "{hello stream=second}", reply));
  EXPECT_TRUE(reply.starts_with("{error 404 ")) << reply;
  folder_.write("second.txt", "Beg_Stream\n2\nEnd_Stream\n");
  server.process().signal(SIGHUP);
  ASSERT_TRUE(logs(server, "serving 2 streams now")) << server.log();
  static_cast<void>(say_hello(server, "{hello stream=second}", reply));
  EXPECT_TRUE(reply.starts_with("{hello ")) << reply;
  EXPECT_EQ(server.terminate(), 0);
}

TEST(ServerSkipBad, ServesTheRestAndSaysWhatIsLeftOut) {
  const TempFolder folder;
  const auto bad = folder.write("bad.txt", "Beg_Stream\nnonsense\nEnd_Stream\n");
  folder.write("good.txt", "Beg_Stream\n1\nEnd_Stream\n");
  EXPECT_EQ(run({program("au-transmitter"), "--port", "0", folder.path()}).exit_code, 3);
  RunningTransmitter server({"--skip-bad", folder.path()});
  RawClient client = server.connect();
  client.send("1");
  EXPECT_EQ(client.receive_all(), "{1}{-2}");
  EXPECT_EQ(server.terminate(), 0);
  EXPECT_NE(server.log().find("left out: " + bad.string() + ":2:1: "), std::string::npos)
      << server.log();
}

TEST_F(ServerReload, UnchangedFilesChangeNothing) {
  RunningTransmitter server({write("1\n")});
  server.process().signal(SIGHUP);
  EXPECT_TRUE(logs(server, "the sources hold what they held")) << server.log();
  EXPECT_EQ(server.terminate(), 0);
}

/// The AUs of keyframes that have one each.
std::vector<int> aus_of(const std::string& packets) {
  std::vector<int> aus;
  for (std::size_t at = packets.find('{'); at != std::string::npos;
       at = packets.find('{', at + 1)) {
    const bool sided = at + 1 < packets.size() && packets[at + 1] == 'R';  // 30, 36 and 46
    const int au = std::atoi(packets.c_str() + at + (sided ? 2 : 1));
    if (au > 0) aus.push_back(au);
  }
  return aus;
}

/// The keyframes of a live stream that everybody saw, over a reload in which another one changed.
struct SeenOverReload {
  std::vector<int> before;  ///< by who was there before it
  std::vector<int> after;   ///< by who came after it
  bool left_out = false;    ///< the transmitter was held up for too long to send every one
};

SeenOverReload reload_while_live(const TempFolder& folder, const std::string& live) {
  const auto other = folder.write("other.txt", "Beg_Stream\n7;50\nEnd_Stream\n");
  RunningTransmitter server({"--live", "--loop", live, other});
  std::string hello;
  RawClient before = say_hello(server, "{hello v=2 window=0}", hello);
  std::string of_before;
  for (int count = 0; count < 20; ++count) of_before += before.receive_until("}");
  folder.write("other.txt", "Beg_Stream\n8;50\nEnd_Stream\n");
  server.process().signal(SIGHUP);
  EXPECT_TRUE(logs(server, "serving 2 streams now")) << server.log();
  RawClient after = say_hello(server, "{hello v=2 window=0}", hello);
  std::string of_after;
  for (int count = 0; count < 20; ++count) of_after += after.receive_until("}");
  RawClient changed = say_hello(server, "{hello v=2 window=0 stream=other}", hello);
  EXPECT_EQ(aus_of(changed.receive_until("}")), std::vector{8});
  changed.reset();
  // For both the stream is stopped at one moment.
  server.process().signal(SIGTERM);
  of_before += before.receive_all();
  of_after += after.receive_all();
  EXPECT_TRUE(of_before.ends_with(kEnd) && of_after.ends_with(kEnd));
  before.reset();
  after.reset();
  EXPECT_EQ(server.process().wait(kPatience), 0);
  const bool left_out = server.log().find("were left out") != std::string::npos;
  return {aus_of(of_before), aus_of(of_after), left_out};
}

TEST_F(ServerReload, LiveStreamsThatStayGoOnWithoutAGap) {
  std::string packets;
  for (int au = 1; au <= 99; ++au) packets += std::to_string(au) + ";20\n";
  const std::string live = write(packets);
  // A computer that lets nobody run for a second makes a gap of its own, which is not meant here.
  SeenOverReload seen = reload_while_live(folder_, live);
  for (int more = 0; seen.left_out && more < 4; ++more) seen = reload_while_live(folder_, live);
  ASSERT_FALSE(seen.left_out);
  for (const auto& aus : {seen.before, seen.after}) {
    ASSERT_GE(aus.size(), 20U);
    for (std::size_t i = 1; i < aus.size(); ++i) ASSERT_EQ(aus[i], aus[i - 1] % 99 + 1);
  }
  // One clock may have been asked just before the end, the other just after.
  const int apart = (seen.before.back() - seen.after.back() + 99) % 99;
  EXPECT_TRUE(apart <= 1 || apart == 98) << apart << " keyframes apart";
}

TEST_F(ServerReload, ManyHangupsDisturbNobody) {
  RunningTransmitter server({write("1\n2\n3\n")});
  RawClient client = server.connect();
  EXPECT_EQ(client.receive_until("}"), "{1}");
  for (int round = 0; round < 30; ++round) {
    static_cast<void>(write(std::to_string(10 + round) + "\n"));
    server.process().signal(SIGHUP);
  }
  client.send("111");
  EXPECT_EQ(client.receive_all(), "{2}{3}{-2}");
  EXPECT_EQ(server.terminate(), 0);
}

TEST(ServerService, StatusIsLoggedOnRequest) {
  RunningTransmitter server({stream_file("happiness.txt")});
  RawClient client = server.connect();
  client.send("1");
  EXPECT_EQ(client.receive_all(), kSixPackets[4] + kEnd);
  RawClient waiting = server.connect();
  EXPECT_FALSE(waiting.receive_until("}").empty());
  ASSERT_TRUE(logs(server, "client 1")) << server.log();
  ASSERT_TRUE(logs(server, "closed")) << server.log();
  server.process().signal(SIGUSR1);
  ASSERT_TRUE(logs(server, "streams: happiness")) << server.log();
  const std::string log = server.log();
  EXPECT_TRUE(std::regex_search(log, std::regex("status: up .*; clients 1, paused 0, behind 0")));
  EXPECT_TRUE(std::regex_search(log, std::regex("status: came 2, left 1 \\(1 finished\\)")));
  EXPECT_TRUE(std::regex_search(log, std::regex("status: sent 2 packets, "))) << log;
  EXPECT_EQ(server.terminate(), 0);
}

TEST(ServerService, LogLinesAreJsonWhenAsked) {
  RunningTransmitter server({"--log-format", "json", stream_file("happiness.txt")});
  RawClient client = server.connect();
  client.send("\x1b[31m\"\\");
  EXPECT_EQ(client.receive_all(), "");
  EXPECT_EQ(server.terminate(), 0);
  std::istringstream lines(server.log());
  int warnings = 0;
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    const auto entry = nlohmann::json::parse(line, nullptr, false);
    ASSERT_FALSE(entry.is_discarded()) << line;
    EXPECT_EQ(entry["program"], "au-transmitter");
    const std::string time = entry["time"];
    EXPECT_TRUE(std::regex_match(
        time, std::regex("[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}\\.[0-9]{3}Z")));
    if (entry["level"] == "warning") ++warnings;
    EXPECT_EQ(line.find('\x1b'), std::string::npos) << line;
  }
  EXPECT_GT(count, 2);
  EXPECT_GE(warnings, 1) << server.log();
}

TEST(ServerService, FloodOfClientsIsLoggedInPartAndCounted) {
  constexpr int kClients = 400;
  RunningTransmitter server({stream_file("happiness.txt")});
  for (int client = 0; client < kClients; ++client) {
    RawClient rude = server.connect();
    rude.send("x");
    EXPECT_EQ(rude.receive_all(), "");
  }
  EXPECT_EQ(server.terminate(), 0);
  std::istringstream lines(server.log());
  int said = 0;
  int left_out = 0;
  std::smatch count;
  for (std::string line; std::getline(lines, line);) {
    if (line.find(": client ") != std::string::npos) ++said;
    if (std::regex_search(line, count, std::regex("([0-9]+) lines about clients"))) {
      left_out += std::stoi(count[1]);
    }
  }
  EXPECT_GE(said, 300);
  EXPECT_EQ(said + left_out, 2 * kClients) << "each comes and goes";
}

/// Takes a whole stream, so that the server is known to go round its loop.
void take_stream(const std::string& ready_line) {
  RawClient client(ready_line.substr(ready_line.rfind(' ') + 1));
  client.send("1");
  EXPECT_EQ(client.receive_all(), "{1,6,12,14}{-2}");
}

TEST(ServerService, JournalLinesBeginWithTheirPriority) {
  const std::string start =
      "JOURNAL_STREAM=$(stat -Lc %d:%i /proc/self/fd/2) exec \"$0\" --port 0 \"$1\"";
  Process process({"sh", "-c", start, program("au-transmitter"), stream_file("happiness.txt")});
  const auto line = process.read_line(kPatience);
  ASSERT_TRUE(line) << process.err();
  take_stream(*line);
  process.signal(SIGTERM);
  ASSERT_EQ(process.wait(kPatience), 0);
  std::istringstream lines(process.err());
  int count = 0;
  for (std::string entry; std::getline(lines, entry); ++count) {
    EXPECT_TRUE(entry.starts_with("<6>")) << entry;
    EXPECT_EQ(entry.find("info"), std::string::npos) << "the journal knows time, level and program";
  }
  EXPECT_GE(count, 2);
}

TEST(ServerService, JournalKnowsThatWhatEndsItIsAnError) {
  const TempFolder folder;
  const auto bad = folder.write("bad.txt", "Beg_Stream\nnonsense\n1,,2\nEnd_Stream\n");
  const std::string start =
      "JOURNAL_STREAM=$(stat -Lc %d:%i /proc/self/fd/2) exec \"$0\" --port 0 \"$1\"";
  for (const auto& [source, code] : {std::pair{bad.string(), 3}, {bad.string() + "not", 4}}) {
    const Finished ended = run({"sh", "-c", start, program("au-transmitter"), source});
    EXPECT_EQ(ended.exit_code, code);
    std::istringstream lines(ended.err);
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
      EXPECT_TRUE(line.starts_with("<3>")) << line;
    }
    EXPECT_EQ(count, code == 3 ? 2 : 1) << ended.err;
  }
}

TEST(ServerService, JournalOfAnotherIsNoneOfOurs) {
  Process process({program("au-transmitter"), "--port", "0", stream_file("happiness.txt")},
                  {"JOURNAL_STREAM=1:1"});
  const auto line = process.read_line(kPatience);
  ASSERT_TRUE(line) << process.err();
  take_stream(*line);
  process.signal(SIGTERM);
  ASSERT_EQ(process.wait(kPatience), 0);
  EXPECT_EQ(process.err().find('<'), std::string::npos) << process.err();
}

}  // namespace
}  // namespace aucast::test
