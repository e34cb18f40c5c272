#include "server/settings/settings.h"

#include <set>

#include <gtest/gtest.h>

#include "server/settings/option_table.h"
#include "tests/support/temp_folder.h"

namespace aucast::server {
namespace {

using test::TempFolder;

std::string file_error(std::string_view text) {
  TransmitterOptions options;
  const auto rows = option_rows(options);
  Settings settings(rows);
  auto done = settings.add_file(text, "s.toml");
  if (done) done = settings.read();
  if (done) return "accepted";
  EXPECT_EQ(done.error().kind, ErrorKind::BadData);
  return done.error().message;
}

std::string environment_error(const Environment& environment) {
  const auto command = read_command_line({"a.txt"}, {environment, {}});
  if (command) return "accepted";
  EXPECT_EQ(command.error().kind, ErrorKind::Usage);
  return command.error().message;
}

TransmitterOptions read(std::vector<std::string> arguments, const Surroundings& surroundings) {
  const auto command = read_command_line(std::move(arguments), surroundings);
  if (!command) {
    ADD_FAILURE() << command.error().message;
    return {};
  }
  return command->options;
}

TEST(OptionTable, DefaultsAreThoseOfTheStruct) {
  TransmitterOptions options;
  options.bind = "";
  options.port = 0;
  options.keyframe_ms = 0;
  options.live = true;
  const auto rows = option_rows(options);
  const auto read = Settings(rows).read();
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(options, TransmitterOptions{});
}

TEST(OptionTable, NamesAreDistinctAndExplained) {
  TransmitterOptions options;
  const auto rows = option_rows(options);
  std::set<std::string_view> names;
  for (const OptionRow& row : rows) {
    EXPECT_TRUE(names.insert(row.option.name).second) << row.option.name;
    ASSERT_FALSE(row.more.empty()) << row.option.name;
    EXPECT_EQ(row.more.back(), '.') << row.option.name;
    EXPECT_EQ(row.option.argument.empty(), row.value.kind == OptionValue::Kind::Flag)
        << row.option.name;
    EXPECT_EQ(find_row(rows, row.option.name), &row);
  }
  EXPECT_EQ(find_row(rows, "none"), nullptr);
}

TEST(Settings, LaterLayersWin) {
  const TempFolder folder;
  const auto file = folder.write("s.toml",
                                 "source = ['file.txt', 'more.txt']\nport = 1\nkeyframe = 11\n"
                                 "loop = true\nclassic-min = 31\nclient-timeout = 2.5\n");
  const Surroundings surroundings{{{"AUCAST_TRANSMITTER_PORT", "2"},
                                   {"AUCAST_TRANSMITTER_KEYFRAME", "12"},
                                   {"AUCAST_TRANSMITTER_STATS", ""},
                                   {"HOME", "/"}},
                                  file};
  TransmitterOptions expected;
  expected.sources = {"file.txt", "more.txt"};
  expected.port = 3;
  expected.keyframe_ms = 12;
  expected.loop = true;
  expected.classic_min = 31;
  expected.client_timeout = Milliseconds(2500);
  EXPECT_EQ(read({"--port", "3"}, surroundings), expected);
  expected.sources = {"typed.txt"};
  EXPECT_EQ(read({"--port", "3", "typed.txt"}, surroundings), expected) << "replaces the list";
}

TEST(Settings, FileIsFoundByOptionThenEnvironmentThenUsualPlace) {
  const TempFolder folder;
  const auto usual = folder.write("usual.toml", "source = 'usual'\n");
  const auto named = folder.write("named.toml", "source = 'named'\n");
  const auto typed = folder.write("typed.toml", "source = 'typed'\n");
  const Environment environment{{"AUCAST_TRANSMITTER_CONFIG", named.string()}};
  using Paths = std::vector<std::filesystem::path>;
  EXPECT_EQ(read({}, {{}, usual}).sources, Paths{"usual"});
  EXPECT_EQ(read({}, {environment, usual}).sources, Paths{"named"});
  EXPECT_EQ(read({"--config", typed}, {environment, usual}).sources, Paths{"typed"});
  EXPECT_EQ(read({"a"}, {{}, folder.path() / "absent.toml"}).sources, Paths{"a"});
  EXPECT_EQ(read({"--config", "/dev/null", "a"}, {{}, usual}).sources, Paths{"a"});
}

TEST(Settings, FileThatIsNotThereIsUnreadable) {
  const auto command = read_command_line({"--config", "/nowhere/s.toml", "a"});
  ASSERT_FALSE(command);
  EXPECT_EQ(command.error().kind, ErrorKind::Unreadable);
  EXPECT_NE(command.error().message.find("/nowhere/s.toml: cannot be read"), std::string::npos);
}

TEST(Settings, ErrorsOfTheFileNameThePlace) {
  EXPECT_EQ(file_error("port = 1\nprot = 2\n"),
            "s.toml:2:1: 'prot' is none of the settings; did you mean 'port'?");
  EXPECT_EQ(file_error("entirely-different = 2\n"),
            "s.toml:1:1: 'entirely-different' is none of the settings");
  EXPECT_EQ(file_error("port = 70000"),
            "s.toml:1:8: port '70000' is not a whole number from 0 to 65535");
  EXPECT_EQ(file_error("port = true"), "s.toml:1:8: port is not a number");
  EXPECT_EQ(file_error("bind = 5"), "s.toml:1:8: bind is not a string in quotes");
  EXPECT_EQ(file_error("loop = 'yes'"), "s.toml:1:8: loop is not true or false");
  EXPECT_EQ(file_error("source = ['a', 1]"),
            "s.toml:1:10: source is not a string in quotes, or a list of them in brackets");
  EXPECT_EQ(file_error("bind = ''"), "s.toml:1:8: bind '' is empty");
  EXPECT_EQ(file_error("check = true"), "s.toml:1:1: 'check' is for the command line only");
  EXPECT_EQ(file_error("[server]\nport = 1"), "s.toml:1:2: 'server' is none of the settings");
  EXPECT_TRUE(file_error("port = 1\nport = 2\n").starts_with("s.toml:2:")) << "twice";
  EXPECT_TRUE(file_error("port = \n").starts_with("s.toml:1:")) << "no TOML";
  EXPECT_EQ(file_error("\n# nothing\n"), "accepted");
}

TEST(Settings, ErrorsOfTheEnvironmentNameTheVariable) {
  EXPECT_EQ(environment_error({{"AUCAST_TRANSMITTER_PORT", "x"}}),
            "AUCAST_TRANSMITTER_PORT 'x' is not a whole number from 0 to 65535 (try --help)");
  EXPECT_EQ(environment_error({{"AUCAST_TRANSMITTER_LOOP", "yes"}}),
            "AUCAST_TRANSMITTER_LOOP 'yes' is neither true nor false (try --help)");
  EXPECT_EQ(environment_error({{"AUCAST_TRANSMITTER_PROT", "1"}}),
            "environment: 'AUCAST_TRANSMITTER_PROT' is none of the settings; did you mean "
            "'AUCAST_TRANSMITTER_PORT'?");
  EXPECT_EQ(environment_error({{"AUCAST_TRANSMITTER_CHECK", "true"}}),
            "AUCAST_TRANSMITTER_CHECK: --check is for the command line only (try --help)");
  EXPECT_EQ(environment_error({{"AUCAST_DATA", "somewhere"}}), "accepted");
}

TEST(Settings, PrintedOnesCanBeFedBack) {
  const TempFolder folder;
  const auto file = folder.write("s.toml", "port = 7\nmin-confidence = 0.25\nau-scale = 'auto'\n");
  const Surroundings surroundings{
      {{"AUCAST_TRANSMITTER_BIND", "::1"}, {"AUCAST_TRANSMITTER_SOURCE", "a b.txt,c\"d\\.txt"}},
      file};
  std::vector<std::string> arguments = {"--live", "--stats", "tab\tnew\nline.json", "--rate",
                                        "2.5"};
  const TransmitterOptions options = read(arguments, surroundings);
  arguments.emplace_back("--print-config");
  const auto printed = read_command_line(arguments, surroundings);
  ASSERT_TRUE(printed);
  for (const std::string& line : std::vector<std::string>{
           "port = 7  # " + file.string() + ":1\n",
           std::string("bind = \"::1\"  # environment AUCAST_TRANSMITTER_BIND\n"),
           std::string("source = [\"a b.txt\", \"c\\\"d\\\\.txt\"]  # environment"),
           std::string("live = true  # command line\n"),
           std::string("rate = 2.5  # command line\n"), std::string("loop = false  # default\n"),
           std::string("# fps is not set\n")}) {
    EXPECT_NE(printed->text.find(line), std::string::npos) << line << printed->text;
  }
  const auto again = folder.write("again.toml", printed->text);
  EXPECT_EQ(read({"--config", again}, {}), options);
}

TEST(Settings, PrintedOnesSayWhatAProfileMakesOfThem) {
  const TempFolder folder;
  const auto profile = folder.write("p.toml", "[gain]\nall = 2\n45 = 3\n[filter]\nbeta = 4\n");
  const std::vector<std::string> arguments{"--profile",   profile, "--gain",        "45=1.5",
                                           "--dead-band", "3",     "--print-config"};
  const auto printed = read_command_line(arguments);
  ASSERT_TRUE(printed) << printed.error().message;
  for (const char* line :
       {"\ngain = \"45=1.5\"  # command line\n", "\ndead-band = 3  # command line\n",
        "\n# filter is not set\n", "\n#   all = 2\n#   45 = 1.5\n",
        "\n#   [dead-band]\n#   all = 3\n", "\n#   beta = 4\n"}) {
    EXPECT_NE(printed->text.find(line), std::string::npos) << line << printed->text;
  }
  const auto again = folder.write("again.toml", printed->text);
  TransmitterOptions expected;
  expected.source.signal.profile = profile;
  expected.source.signal.gain = {{sources::AuName{45, Side::Both}, 1.5}};
  expected.source.signal.dead_band = {{std::nullopt, 3}};
  expected.sources = {"a"};
  EXPECT_EQ(read({"--config", again, "a"}, {}), expected);
  EXPECT_EQ(read_command_line({"--profile", folder.path() / "none", "--print-config"}).error().kind,
            ErrorKind::Unreadable);
}

TEST(Settings, PrintingNeedsNoSource) {
  const auto printed = read_command_line({"--print-config"});
  ASSERT_TRUE(printed) << printed.error().message;
  EXPECT_NE(printed->text.find("# source is not set\n"), std::string::npos);
}

}  // namespace
}  // namespace aucast::server
