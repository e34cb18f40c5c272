// au-transmitter's command line, files and exit codes.
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/integration/server_running.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

using namespace std::chrono_literals;

Finished transmit(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), program("au-transmitter"));
  return run(std::move(arguments));
}

TEST(ServerProgram, SaysWhereItListensAndNothingElseOnStdout) {
  RunningTransmitter server({stream_file("happiness.txt")});
  RawClient client = server.connect();
  client.send("1");
  EXPECT_EQ(client.receive_all(), kSixPackets[4] + kEnd);
  EXPECT_EQ(server.terminate(), 0);
  EXPECT_EQ(server.process().out(), "listening on " + server.address() + "\n");
  EXPECT_TRUE(server.address().starts_with("127.0.0.1:"));
  EXPECT_TRUE(has(server.log(), "only programs on this host can connect; --bind 0.0.0.0"));
}

TEST(ServerProgram, QuietSaysNothingOfOrdinaryClients) {
  RunningTransmitter server({"-q", stream_file("happiness.txt")});
  RawClient client = server.connect();
  client.send("1");
  EXPECT_EQ(client.receive_all(), kSixPackets[4] + kEnd);
  EXPECT_EQ(server.terminate(), 0);
  EXPECT_EQ(server.log(), "");
}

TEST(ServerProgram, ListensOnNamesAndOnAllAddresses) {
  for (const char* bind : {"localhost", "0.0.0.0"}) {
    RunningTransmitter server({"--bind", bind, stream_file("happiness.txt")});
    RawClient client(bind[0] == '0' ? "127.0.0.1:" + server.port() : server.address());
    client.send("1");
    EXPECT_EQ(client.receive_all(), kSixPackets[4] + kEnd) << bind;
  }
}

TEST(ServerProgram, ListensOnIpv6) {
  for (const char* bind : {"::1", "[::1]"}) {
    Process process(
        {program("au-transmitter"), "--port", "0", "--bind", bind, stream_file("happiness.txt")});
    const auto line = process.read_line(kPatience);
    if (!line) {
      EXPECT_EQ(process.wait(kPatience), 5);
      GTEST_SKIP() << "no IPv6 here: " << process.err();
    }
    ASSERT_TRUE(line->starts_with("listening on [::1]:")) << *line;
    RawClient client(line->substr(line->rfind(' ') + 1));
    client.send("1");
    EXPECT_EQ(client.receive_all(), kSixPackets[4] + kEnd);
  }
}

TEST(ServerProgram, PortThatIsTakenIsNamedWithTheRemedy) {
  RunningTransmitter server({stream_file("happiness.txt")});
  const Finished second = transmit({"--port", server.port(), stream_file("happiness.txt")});
  EXPECT_EQ(second.exit_code, 5);
  EXPECT_EQ(second.out, "");
  EXPECT_TRUE(has(second.err, "cannot listen on " + server.address() +
                                  ": Address already in use; another program has this port"))
      << second.err;
  EXPECT_TRUE(has(second.err, "--port"));
}

TEST(ServerProgram, PortIsFreeAgainAtOnce) {
  std::string port;
  {
    RunningTransmitter server({stream_file("happiness.txt")});
    port = server.port();
    RawClient client = server.connect();
    EXPECT_FALSE(client.receive_until("}").empty());
    EXPECT_EQ(server.terminate(), 0);
  }
  RunningTransmitter again({"--bind", "127.0.0.1", stream_file("happiness.txt")});
  Process same({program("au-transmitter"), "--port", port, stream_file("happiness.txt")});
  EXPECT_EQ(same.read_line(kPatience), "listening on 127.0.0.1:" + port) << same.err();
}

TEST(ServerProgram, AddressOfAnotherHostIsRefused) {
  const Finished elsewhere =
      transmit({"--bind", "192.0.2.7", "--port", "0", stream_file("happiness.txt")});
  EXPECT_EQ(elsewhere.exit_code, 5);
  EXPECT_TRUE(has(elsewhere.err, "cannot listen on 192.0.2.7:0: ")) << elsewhere.err;
  EXPECT_TRUE(has(elsewhere.err, "not an address of this host"));
  const Finished nonsense = transmit({"--bind", "not a host", stream_file("happiness.txt")});
  EXPECT_EQ(nonsense.exit_code, 5);
  EXPECT_TRUE(has(nonsense.err, "cannot listen on not a host:4650: ")) << nonsense.err;
}

TEST(ServerProgram, SettingsComeFromFileAndEnvironment) {
  const TempFolder folder;
  const auto file = folder.write(
      "s.toml", "source = '" + stream_file("happiness.txt") + "'\nport = 0\nbind = '192.0.2.7'\n");
  Process process({program("au-transmitter"), "--config", file},
                  {"AUCAST_TRANSMITTER_BIND=127.0.0.1"});
  const auto line = process.read_line(kPatience);
  ASSERT_TRUE(line && line->starts_with("listening on 127.0.0.1:")) << process.err();
  RawClient client(line->substr(line->rfind(' ') + 1));
  client.send("1");
  EXPECT_EQ(client.receive_all(), kSixPackets[4] + kEnd);

  const auto wrong = folder.write("wrong.toml", "port = 0\nlop = true\n");
  const Finished bad = transmit({"--config", wrong, stream_file("happiness.txt")});
  EXPECT_EQ(bad.exit_code, 3);
  EXPECT_EQ(bad.err,
            wrong.string() + ":2:1: 'lop' is none of the settings; did you mean 'loop'?\n");
  EXPECT_EQ(transmit({"--config", folder.path() / "none.toml"}).exit_code, 4);
}

TEST(ServerProgram, UsageErrorsAreOneLineAndCodeTwo) {
  const std::vector<std::vector<std::string>> wrong = {
      {},
      {"--prot", "1", "a.txt"},
      {"--port", "99999", "a.txt"},
      {"--log-level", "loud", stream_file("happiness.txt")},
      {"--max-clients", "many", stream_file("happiness.txt")}};
  for (const auto& arguments : wrong) {
    const Finished finished = transmit(arguments);
    EXPECT_EQ(finished.exit_code, 2);
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
    EXPECT_TRUE(finished.err.starts_with("au-transmitter: ")) << finished.err;
  }
  EXPECT_TRUE(has(transmit({"--prot", "1"}).err, "unknown option --prot; did you mean --port?"));
}

TEST(ServerProgram, HelpAndVersionGoToStdout) {
  for (const char* option : {"--help", "-h", "--version"}) {
    const Finished finished = transmit({option});
    EXPECT_EQ(finished.exit_code, 0);
    EXPECT_TRUE(has(finished.out, "au-transmitter"));
    EXPECT_EQ(finished.err, "");
  }
}

TEST(ServerProgram, EveryBadSourceIsRefusedWithItsPlace) {
  for (const auto& entry : std::filesystem::directory_iterator(program("data/streams/bad"))) {
    const std::string file = entry.path().string();
    const Finished finished = transmit({"--port", "0", file});
    EXPECT_EQ(finished.exit_code, 3) << file;
    EXPECT_EQ(finished.out, "");
    ASSERT_TRUE(finished.err.starts_with(file + ":")) << finished.err;
    EXPECT_TRUE(
        std::regex_search(finished.err.substr(file.size()), std::regex("^:[0-9]+:[0-9]+: [^\n]")))
        << finished.err;
    EXPECT_TRUE(std::all_of(finished.err.begin(), finished.err.end(), [](char byte) {
      return byte == '\n' || (byte >= ' ' && byte <= '~');
    })) << "what a file holds is escaped";
  }
}

TEST(ServerProgram, LineWithoutEndIsRefused) {
  const TempFolder folder;
  std::string line = "1";
  while (line.size() < 200'000) line += ",1";
  const auto file = folder.write("long.txt", "Beg_Stream\n" + line);
  const Finished finished = transmit({"--port", "0", file.string()});
  EXPECT_EQ(finished.exit_code, 3);
  EXPECT_TRUE(finished.err.starts_with(file.string() + ":2:")) << finished.err.substr(0, 500);
}

TEST(ServerProgram, FirstTwentyErrorsAreReportedAndTheRestCounted) {
  const std::string file = program("data/streams/bad/many_errors.txt");
  const Finished finished = transmit({"--port", "0", file});
  EXPECT_EQ(finished.exit_code, 3);
  EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 21) << finished.err;
  EXPECT_TRUE(has(finished.err, file + ":21:"));
  EXPECT_FALSE(has(finished.err, file + ":22:"));
}

TEST(ServerProgram, SourceThatCannotBeReadIsCodeFour) {
  const TempFolder folder;
  const std::string missing = (folder.path() / "none.txt").string();
  const Finished none = transmit({"--port", "0", missing});
  EXPECT_EQ(none.exit_code, 4);
  EXPECT_TRUE(has(none.err, missing + ": cannot be read: No such file or directory")) << none.err;
  EXPECT_EQ(transmit({"--port", "0", folder.path().string()}).exit_code, 3) << "empty";
  if (::geteuid() != 0) {
    const auto locked = folder.write("locked.txt", "Beg_Stream\n1\nEnd_Stream\n");
    std::filesystem::permissions(locked, std::filesystem::perms::none);
    EXPECT_EQ(transmit({"--port", "0", locked.string()}).exit_code, 4);
  }
}

TEST(ServerProgram, OneBadSourceOfManyServesNothingAndAllAreReported) {
  const TempFolder folder;
  const auto bad = folder.write("bad.txt", "Beg_Stream\n1x2\n100\nEnd_Stream\n");
  const Finished finished =
      transmit({"--port", "0", stream_file("happiness.txt"), bad.string(), "/no/such/file.txt"});
  EXPECT_EQ(finished.exit_code, 3);
  EXPECT_EQ(finished.out, "");
  EXPECT_TRUE(has(finished.err, bad.string() + ":2:"));
  EXPECT_TRUE(has(finished.err, bad.string() + ":3:"));
  EXPECT_TRUE(has(finished.err, "/no/such/file.txt: cannot be read"));
}

TEST(ServerProgram, CheckPrintsWhatTheSourcesHoldAndServesNothing) {
  const Finished finished =
      transmit({"--check", stream_file("six_expressions.txt"), stream_file("talk.txt")});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(finished.err, "");
  EXPECT_TRUE(has(finished.out, "six_expressions: "));
  EXPECT_TRUE(has(finished.out, "  keyframes   6, 6 of them untimed\n")) << finished.out;
  EXPECT_TRUE(has(finished.out, "  duration    1.500 s"));
  EXPECT_TRUE(has(finished.out, "  classic     90 bytes, 15.0 a keyframe (11 to 19)\n"));
  EXPECT_TRUE(has(finished.out, "talk: "));
  EXPECT_FALSE(has(finished.out, "listening"));
}

TEST(ServerProgram, CheckRefusesWhatCannotBeServed) {
  const Finished finished = transmit({"--check", program("data/streams/bad/au_100.txt")});
  EXPECT_EQ(finished.exit_code, 3);
  EXPECT_EQ(finished.out, "");
}

/// The client in the statistics whose peer is `client`; null when there is none.
nlohmann::json record_of(const nlohmann::json& stats, std::uint16_t port) {
  for (const auto& record : stats.at("clients")) {
    if (record.at("peer") == "127.0.0.1:" + std::to_string(port)) return record;
  }
  return {};
}

TEST(ServerProgram, StatsCountEveryClientAndAll) {
  const TempFolder folder;
  RunningTransmitter server({"--stats", (folder.path() / "stats.json").string(),
                             stream_file("six_expressions.txt"), stream_file("happiness.txt")});
  EXPECT_TRUE(folder.read("stats.json").empty()) << "what was there stays until there are numbers";
  RawClient first = server.connect();
  expect_six_packets(first);
  std::string reply;
  RawClient second = say_hello(server, "{hello v=2 window=4 stream=happiness}", reply);
  EXPECT_TRUE(reply.starts_with("{hello "));
  EXPECT_EQ(second.receive_until("}"), kSixPackets[4]);
  second.send("-4");
  EXPECT_EQ(second.receive_all(), kEnd);
  RawClient third = server.connect();
  third.send("?");
  EXPECT_TRUE(third.wait_for_end());
  const std::vector<std::uint16_t> ports = {first.local_port(), second.local_port(),
                                            third.local_port()};
  EXPECT_EQ(server.terminate(), 0);

  const auto stats = nlohmann::json::parse(folder.read("stats.json"));
  const auto one = record_of(stats, ports[0]);
  EXPECT_EQ(one.at("client"), 1);
  EXPECT_EQ(one.at("packets"), 6);
  EXPECT_EQ(one.at("bytes"), 90);
  EXPECT_EQ(one.at("bytes_total"), 94);
  EXPECT_EQ(one.at("level"), 1);
  EXPECT_EQ(one.at("stream"), "six_expressions");
  EXPECT_EQ(one.at("end_reason"), "finished");
  EXPECT_GT(one.at("send_seconds").get<double>(), 0.0);
  const auto two = record_of(stats, ports[1]);
  EXPECT_EQ(two.at("level"), 2);
  EXPECT_EQ(two.at("stream"), "happiness");
  EXPECT_EQ(two.at("packets"), 1);
  EXPECT_EQ(two.at("bytes"), 11);
  EXPECT_EQ(two.at("bytes_total"), reply.size() + 11 + kEnd.size());
  EXPECT_EQ(two.at("end_reason"), "stopped");
  EXPECT_EQ(record_of(stats, ports[2]).at("end_reason"), "protocol error");
  EXPECT_GE(stats.at("clients_total"), 3);
  EXPECT_GE(stats.at("packets"), 7);
  EXPECT_GE(stats.at("bytes"), 101);
}

TEST(ServerProgram, StatsThatCannotBeWrittenAreSaidBeforeServing) {
  const Finished finished =
      transmit({"--port", "0", "--stats", "/no/such/folder/s.json", stream_file("happiness.txt")});
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_EQ(finished.out, "");
  EXPECT_TRUE(has(finished.err, "/no/such/folder/s.json: cannot be written: ")) << finished.err;
}

TEST(ServerProgram, StatsGoToAPipeToo) {
  RunningTransmitter server({"--stats", "/dev/stderr", "-q", stream_file("happiness.txt")});
  EXPECT_EQ(server.terminate(), 0);
  EXPECT_TRUE(nlohmann::json::accept(server.log())) << server.log();
}

TEST(ServerProgram, ALogThatNobodyReadsHoldsUpNobody) {
  // Nobody looks into the pipe of stderr until the end: it is full long before.
  RunningTransmitter server({"--log-level", "trace", stream_file("happiness.txt")});
  for (int i = 0; i < 600; ++i) {
    RawClient client = server.connect();
    ASSERT_TRUE(client.send("-4")) << i;
    ASSERT_TRUE(client.wait_for_end()) << i;
  }
  EXPECT_EQ(server.process().read_line(std::chrono::milliseconds(100)), std::nullopt);
  EXPECT_GT(server.log().size(), 50'000U);
  RawClient reader = server.connect();
  ASSERT_TRUE(reader.send("-4"));
  ASSERT_TRUE(reader.wait_for_end());
  EXPECT_EQ(server.terminate(), 0);
  EXPECT_TRUE(has(server.log(), "lines of the log were dropped here"));
}

TEST(ServerProgram, RunsFromAnyFolder) {
  const TempFolder folder;
  folder.write("mine.txt", "Beg_Stream\n6,12\nEnd_Stream\n");
  const Finished finished = run(
      {"sh", "-c",
       "cd " + folder.path().string() + " && " + program("au-transmitter") + " --check mine.txt"});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_TRUE(finished.out.starts_with("mine: mine.txt\n")) << finished.out;
}

}  // namespace
}  // namespace aucast::test
