#include "server/settings/transmitter_options.h"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

#include "server/settings/option_table.h"

namespace aucast::server {
namespace {

TransmitterOptions read(std::vector<std::string> arguments) {
  const auto command = read_command_line(std::move(arguments));
  if (!command) {
    ADD_FAILURE() << command.error().message;
    return {};
  }
  EXPECT_EQ(command->text, "");
  return command->options;
}

std::string message(std::vector<std::string> arguments) {
  const auto command = read_command_line(std::move(arguments));
  if (command) return "accepted";
  EXPECT_EQ(command.error().kind, ErrorKind::Usage);
  EXPECT_EQ(command.error().message.find('\n'), std::string::npos) << "one line";
  return command.error().message;
}

TEST(TransmitterOptions, DefaultsAreThoseOfTheHelp) {
  TransmitterOptions expected;
  expected.sources = {"talk.txt"};
  EXPECT_EQ(read({"talk.txt"}), expected);
  EXPECT_EQ(expected.bind, "127.0.0.1");
  EXPECT_EQ(expected.port, 4650);
  EXPECT_EQ(expected.keyframe_ms, 250U);
  EXPECT_EQ(expected.classic_min, 20);
  EXPECT_EQ(expected.client_timeout.count(), 0);
  EXPECT_EQ(expected.log_level, "info");
}

TEST(TransmitterOptions, SecretsThatNobodyIsShownAreAMistake) {
  for (const char* name : {"--push-token-file", "--push-tls-ca", "--upstream-token-file",
                           "--upstream-tls-ca", "--nats-creds", "--nats-tls-ca"}) {
    EXPECT_NE(message({"talk.txt", name, "missing"}).find(" need "), std::string::npos) << name;
  }
  EXPECT_EQ(message({"talk.txt", "--push", "aucast://a", "--push-token-file", "f"}), "accepted");
  EXPECT_EQ(message({"aucast://a/talk", "--upstream-token-file", "f"}), "accepted");
  EXPECT_EQ(message({"nats://a/talk", "--nats-creds", "f"}), "accepted");
  EXPECT_EQ(message({"talk.txt", "--publish", "nats://a/talk", "--nats-creds", "f"}), "accepted");
}

TEST(TransmitterOptions, OneStreamIsPushedToOneServerOnce) {
  const auto both = [](const std::string& one, const std::string& other) {
    return message({"talk.txt", "--push", one, "--push", other});
  };
  EXPECT_EQ(both("aucast://a/talk", "aucast://a:4650/talk"),
            "--push aucast://a:4650/talk is there twice: leave one out (try --help)");
  EXPECT_EQ(both("aucast://a/talk", "aucast://a/other"), "accepted");
  EXPECT_EQ(both("aucast://a/talk", "aucast://b/talk"), "accepted");
}

TEST(TransmitterOptions, EveryOptionIsRead) {
  const auto options = read(
      {"--bind",      "::1",   "--port=0", "--keyframe",       "40",  "--loop",   "--classic-min",
       "35",          "a.txt", "--check",  "--client-timeout", "2.5", "--stats",  "out/s.json",
       "--log-level", "trace", "--live",   "--max-clients",    "12",  "dir/b.txt"});
  TransmitterOptions expected;
  expected.sources = {"a.txt", "dir/b.txt"};
  expected.bind = "::1";
  expected.port = 0;
  expected.keyframe_ms = 40;
  expected.loop = true;
  expected.classic_min = 35;
  expected.client_timeout = Milliseconds(2500);
  expected.stats = "out/s.json";
  expected.check = true;
  expected.live = true;
  expected.max_clients = 12;
  expected.log_level = "trace";
  EXPECT_EQ(options, expected);
}

TEST(TransmitterOptions, VerboseAndQuietAreLevels) {
  EXPECT_EQ(read({"-v", "a"}).log_level, "debug");
  EXPECT_EQ(read({"--quiet", "a"}).log_level, "error");
  EXPECT_EQ(read({"-q", "--log-level", "trace", "a"}).log_level, "trace");
  EXPECT_EQ(message({"-q", "-v", "a"}), "-v and -q exclude each other (try --help)");
}

TEST(TransmitterOptions, LimitsAreInside) {
  EXPECT_EQ(read({"--port", "65535", "a"}).port, 65535);
  EXPECT_EQ(read({"--keyframe", "1", "a"}).keyframe_ms, 1U);
  EXPECT_EQ(read({"--keyframe", "3600000", "a"}).keyframe_ms, 3'600'000U);
  EXPECT_EQ(read({"--classic-min", "0", "a"}).classic_min, 0);
  EXPECT_EQ(read({"--classic-min", "100", "a"}).classic_min, 100);
  EXPECT_EQ(read({"--client-timeout", "0", "a"}).client_timeout.count(), 0);
  EXPECT_EQ(read({"--client-timeout", "0.0001", "a"}).client_timeout.count(), 1)
      << "a wait that was asked for never becomes 'for ever'";
}

TEST(TransmitterOptions, AnAddressOfIPv6StandsInBrackets) {
  EXPECT_EQ(read({"--http", "[::1]:9465", "a"}).http, (HttpAddress{"[::1]", 9465}));
  EXPECT_NE(message({"--http", "::1", "a"}).find("such as 127.0.0.1:9465 or [::1]:9465"),
            std::string::npos);
  EXPECT_NE(message({"--web", "::1:8080", "a"}), "") << "where the port begins nobody can tell";
}

TEST(TransmitterOptions, BadNumbersAreNamedWithTheirRange) {
  const std::string port = " is not a whole number from 0 to 65535 (try --help)";
  EXPECT_EQ(message({"--port", "65536", "a"}), "--port '65536'" + port);
  EXPECT_EQ(message({"--port", "-1", "a"}), "--port '-1'" + port);
  EXPECT_EQ(message({"--port", "http", "a"}), "--port 'http'" + port);
  EXPECT_EQ(message({"--port", "46 50", "a"}), "--port '46 50'" + port);
  EXPECT_EQ(message({"--port", "1.5", "a"}), "--port '1.5'" + port);
  EXPECT_EQ(message({"--port", "99999999999999999999", "a"}),
            "--port '99999999999999999999'" + port);
  EXPECT_EQ(message({"--keyframe", "0", "a"}),
            "--keyframe '0' is not a whole number from 1 to 3600000 (try --help)");
  EXPECT_EQ(message({"--classic-min", "101", "a"}),
            "--classic-min '101' is not a whole number from 0 to 100 (try --help)");
  EXPECT_EQ(message({"--max-clients", "-1", "a"}),
            "--max-clients '-1' is not a whole number from 0 to 1000000 (try --help)");
  const std::string seconds = " is not a number of seconds from 0 (never) to 86400 (try --help)";
  EXPECT_EQ(message({"--client-timeout", "-2", "a"}), "--client-timeout '-2'" + seconds);
  EXPECT_EQ(message({"--client-timeout", "nan", "a"}), "--client-timeout 'nan'" + seconds);
  EXPECT_EQ(message({"--client-timeout", "1e9", "a"}), "--client-timeout '1e9'" + seconds);
  EXPECT_EQ(message({"--client-timeout", "2s", "a"}), "--client-timeout '2s'" + seconds);
}

TEST(TransmitterOptions, StatisticsGoToStandardOutputWithAHyphen) {
  EXPECT_EQ(read({"--stats", "-", "a"}).stats, "/dev/stdout");
}

TEST(TransmitterOptions, UnknownOptionNamesTheNearest) {
  EXPECT_EQ(message({"--prot", "1", "a"}),
            "unknown option --prot; did you mean --port? (try --help)");
  EXPECT_EQ(message({"--stat=x", "a"}),
            "unknown option --stat; did you mean --stats? (try --help)");
  EXPECT_EQ(message({"--something-else-altogether", "a"}),
            "unknown option --something-else-altogether (try --help)");
}

TEST(TransmitterOptions, IncompleteCommandLinesAreRefused) {
  EXPECT_NE(message({}).find("no SOURCE"), std::string::npos);
  EXPECT_NE(message({"--loop"}).find("no SOURCE"), std::string::npos);
  EXPECT_NE(message({"a", "--port"}).find("--port"), std::string::npos);
  EXPECT_NE(message({"--port", "1", "--port", "2", "a"}).find("--port"), std::string::npos);
  EXPECT_EQ(message({"--stats", "", "a"}), "--stats is empty (try --help)");
  EXPECT_EQ(message({"--bind", "", "a"}), "--bind is empty (try --help)");
  EXPECT_EQ(message({""}), "SOURCE is empty (try --help)");
}

TEST(TransmitterOptions, ValidateSeesWhatOneOptionAloneCannot) {
  TransmitterOptions good;
  good.sources = {"a"};
  EXPECT_TRUE(validate(good));
  {
    auto bad = good;
    bad.sources.clear();
    EXPECT_FALSE(validate(bad));
  }
  {
    auto bad = good;
    bad.bind.clear();
    EXPECT_FALSE(validate(bad));
  }
  {
    auto bad = good;
    bad.web.hosts = {"a"};
    EXPECT_FALSE(validate(bad)) << "without --web";
    bad.web.address = HttpAddress{"127.0.0.1", 8080};
    EXPECT_TRUE(validate(bad));
    bad.credentials.web.certificate = "a.pem";
    EXPECT_FALSE(validate(bad)) << "without its key";
  }
}

TEST(TransmitterOptions, TheRecordsOfFaceAndVoiceAreTwoFiles) {
  const std::string refused = message({"--voice", "-", "--record", "kept.opus", "webcam.csv"});
  EXPECT_NE(refused.find("give kept.opus another ending, such as .txt"), std::string::npos)
      << refused;
  read({"--voice", "-", "--record", "kept.txt", "webcam.csv"});
  read({"--record", "kept.opus", "webcam.csv"});
}

TEST(TransmitterOptions, HelpIsCompleteAndFitsTheWidthOfATerminal) {
  const auto command = read_command_line({"--help"});
  ASSERT_TRUE(command);
  const CommandPage page = transmitter_page();
  EXPECT_EQ(command->text, help_text(page));
  for (const OptionRow& row : page.rows) {
    EXPECT_NE(command->text.find(typed_name(row) + " "), std::string::npos) << row.option.name;
    EXPECT_FALSE(row.text.empty()) << row.option.name;
    EXPECT_NE(command->text.find(row.text), std::string::npos) << row.option.name;
  }
  std::istringstream lines(command->text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

TEST(TransmitterOptions, VersionNamesProtocolAndLicence) {
  const auto command = read_command_line({"--version"});
  ASSERT_TRUE(command);
  EXPECT_TRUE(command->text.starts_with("au-transmitter "));
  EXPECT_NE(command->text.find("protocol 2"), std::string::npos);
  EXPECT_NE(command->text.find("MIT"), std::string::npos);
}

}  // namespace
}  // namespace aucast::server
