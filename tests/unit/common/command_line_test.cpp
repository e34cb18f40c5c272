#include "common/command_line.h"

#include <gtest/gtest.h>

namespace aucast {
namespace {

class CommandLineTest : public testing::Test {
 protected:
  CommandLineTest() {
    app_.add_option("--speed", speed_)->check(CLI::Range(1, 1000));
    app_.add_flag("-q,--quiet", quiet_);
    app_.add_option("FILE", file_);
  }
  std::string message(std::vector<std::string> arguments) {
    const auto result = parse_command_line(app_, std::move(arguments));
    if (result.has_value()) return "";
    EXPECT_EQ(result.error().kind, ErrorKind::Usage);
    return result.error().message;
  }

  CLI::App app_;
  int speed_ = 0;
  bool quiet_ = false;
  std::string file_;
};

TEST_F(CommandLineTest, FillsTheVariables) {
  EXPECT_EQ(message({"a.txt", "--speed", "250", "-q"}), "");
  EXPECT_EQ(file_, "a.txt");
  EXPECT_EQ(speed_, 250);
  EXPECT_TRUE(quiet_);
}

TEST_F(CommandLineTest, NamesTheNearestOption) {
  EXPECT_EQ(message({"--sped", "3"}), "unknown option --sped; did you mean --speed? (try --help)");
  EXPECT_EQ(message({"--sped=3"}), "unknown option --sped; did you mean --speed? (try --help)");
  EXPECT_EQ(message({"--zzzzzzzzzzzz"}), "unknown option --zzzzzzzzzzzz (try --help)");
}

TEST_F(CommandLineTest, NamesWhatItDidNotExpect) {
  EXPECT_EQ(message({"a.txt", "b.txt"}), "unexpected argument 'b.txt' (try --help)");
}

TEST_F(CommandLineTest, ValuesOutOfRangeAreOneLine) {
  const std::string text = message({"--speed", "0"});
  EXPECT_NE(text.find("--speed"), std::string::npos);
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(message({"--speed"}), "--speed needs a value (try --help)");
  EXPECT_NE(message({"--speed", "fast"}), "");
}

}  // namespace
}  // namespace aucast
