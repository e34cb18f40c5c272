#include "common/options.h"

#include <gtest/gtest.h>

namespace aucast {
namespace {

using Where = OptionRow::Where;

struct Options {
  int port = 5;
  std::optional<int> fps;
  std::chrono::milliseconds wait{0};
  bool loop = false;
  bool config = true;
  std::string level = "info";
  bool classic = false;
  std::vector<std::string> files;
  std::vector<std::string> muscles;
};

std::vector<OptionRow> rows_of(Options& options) {
  return {{.option = {"file", "FILE"}, .value = words(options.files), .where = Where::Positional},
          {.option = {"port", "N"}, .value = whole(options.port, 0, 9)},
          {.option = {"fps", "N"}, .value = whole(options.fps, 1, 240)},
          {.option = {"wait", "S"}, .value = seconds(options.wait, 0, 10, "is no wait")},
          {.option = {"loop"}, .value = flag(options.loop), .letter = 'l'},
          {.option = {"no-config"}, .value = flag(options.config, false)},
          {.option = {"level", "LEVEL"}, .value = log_level(options.level)},
          {.option = {"protocol", "P"},
           .value = one_of(options.classic, {{"auto", false}, {"classic", true}})},
          {.option = {"muscle", "M"}, .value = words(options.muscles)},
          {.option = {"help"}, .value = {OptionValue::Kind::Flag}, .letter = 'h'}};
}

Options read(std::vector<std::string> arguments) {
  Options options;
  const auto rows = rows_of(options);
  const auto typed = sort_arguments(rows, std::move(arguments));
  EXPECT_TRUE(typed) << typed.error().message;
  const auto done = read_words(rows, *typed);
  EXPECT_TRUE(done) << done.error().message;
  return options;
}

std::string message(std::vector<std::string> arguments) {
  Options options;
  const auto rows = rows_of(options);
  const auto typed = sort_arguments(rows, std::move(arguments));
  const auto done = typed ? read_words(rows, *typed) : Result<void>(typed.error());
  if (done) return "accepted";
  EXPECT_EQ(done.error().kind, ErrorKind::Usage);
  return done.error().message;
}

TEST(ApplyVerbosity, PutsALevelWhereNoneWasTyped) {
  using Words = std::vector<std::string>;
  const auto level = [](TypedWords typed) {
    EXPECT_TRUE(apply_verbosity(typed, {"info", "debug"}));
    const auto found = typed.find("log-level");
    return found == typed.end() ? "" : found->second.front();
  };
  EXPECT_EQ(level({}), "");
  EXPECT_EQ(level({{"verbose", Words{"true"}}}), "info");
  EXPECT_EQ(level({{"verbose", Words(2, "true")}}), "debug");
  EXPECT_EQ(level({{"verbose", Words(5, "true")}}), "debug");
  EXPECT_EQ(level({{"verbose", Words{"false"}}}), "");
  EXPECT_EQ(level({{"quiet", Words{"true"}}, {"verbose", Words{"false"}}}), "error");
  EXPECT_EQ(level({{"quiet", Words{"true"}}, {"log-level", Words{"off"}}}), "off");
  TypedWords both{{"quiet", Words{"true"}}, {"verbose", Words{"true"}}};
  EXPECT_EQ(apply_verbosity(both, {"info"}).error().kind, ErrorKind::Usage);
}

TEST(Options, WordsReachTheVariables) {
  const Options options =
      read({"a", "--port", "7", "--fps=25", "b", "-l", "--no-config", "--protocol", "classic",
            "--muscle", "x=1", "--muscle", "y=2", "--level", "off", "--wait", "2.5", "-"});
  EXPECT_EQ(options.files, (std::vector<std::string>{"a", "b", "-"}));
  EXPECT_EQ(options.port, 7);
  EXPECT_EQ(options.fps, 25);
  EXPECT_EQ(options.wait, std::chrono::milliseconds(2500));
  EXPECT_TRUE(options.loop);
  EXPECT_FALSE(options.config);
  EXPECT_EQ(options.level, "off");
  EXPECT_TRUE(options.classic);
  EXPECT_EQ(options.muscles, (std::vector<std::string>{"x=1", "y=2"}));
}

TEST(Options, WhatIsNotTypedStays) {
  const Options options = read({});
  EXPECT_EQ(options.port, 5);
  EXPECT_FALSE(options.fps);
  EXPECT_TRUE(options.config);
}

TEST(Options, UnboundRowsAreDescribedAlone) {
  std::vector<OptionRow> rows;
  {
    Options options;
    rows = unbound(rows_of(options));
  }
  ASSERT_NE(find_row(rows, "port"), nullptr);
  EXPECT_EQ(find_row(rows, "port")->value.kind, OptionValue::Kind::Number);
  for (const OptionRow& row : rows) EXPECT_FALSE(row.value.read) << row.option.name;
}

TEST(Options, FlagsAreCountedAndCanBeTurnedOff) {
  Options options;
  const auto rows = rows_of(options);
  EXPECT_EQ(sort_arguments(rows, {"-l", "--loop"})->at("loop").size(), 2U);
  EXPECT_EQ(sort_arguments(rows, {"-hl"})->size(), 2U);
  EXPECT_FALSE(read({"--loop=false"}).loop);
}

TEST(Options, WrongWordsAreNamedWithWhatIsRight) {
  EXPECT_EQ(message({"--port", "10"}),
            "--port '10' is not a whole number from 0 to 9 (try --help)");
  EXPECT_EQ(message({"--port", "-1"}),
            "--port '-1' is not a whole number from 0 to 9 (try --help)");
  EXPECT_EQ(message({"--port", "7x"}),
            "--port '7x' is not a whole number from 0 to 9 (try --help)");
  EXPECT_EQ(message({"--wait", "11"}), "--wait '11' is no wait (try --help)");
  EXPECT_EQ(message({"--wait", "nan"}), "--wait 'nan' is no wait (try --help)");
  EXPECT_EQ(message({"--protocol", "udp"}),
            "--protocol 'udp' is not one of auto, classic (try --help)");
  EXPECT_EQ(message({"--level", "loud"}),
            "--level 'loud' is not one of trace, debug, info, warning, error, off (try --help)");
}

TEST(Options, EmptyWordsAreSaidToBeEmpty) {
  EXPECT_EQ(message({"--port", ""}), "--port is empty (try --help)");
  EXPECT_EQ(message({""}), "FILE is empty (try --help)");
}

TEST(Options, UnknownMissingAndRepeatedOnesAreRefused) {
  EXPECT_EQ(message({"--prot", "1"}), "unknown option --prot; did you mean --port? (try --help)");
  EXPECT_EQ(message({"--port"}), "--port needs a value (try --help)");
  EXPECT_EQ(message({"--port", "1", "--port", "2"}),
            "--port is given 2 times; give it once (try --help)");
  EXPECT_EQ(message({"--loop=maybe"}), "--loop 'maybe' is neither true nor false (try --help)");
}

TEST(Options, AWaitThatWasAskedForIsNeverNone) {
  EXPECT_EQ(read({"--wait", "0.0001"}).wait, std::chrono::milliseconds(1));
  EXPECT_EQ(read({"--wait", "0"}).wait, std::chrono::milliseconds(0));
  EXPECT_EQ(read({"--wait", "0.07"}).wait, std::chrono::milliseconds(70));
}

}  // namespace
}  // namespace aucast
