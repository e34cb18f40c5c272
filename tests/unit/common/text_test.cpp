#include "common/text.h"

#include <cerrno>

#include <gtest/gtest.h>

namespace aucast {
namespace {

TEST(Escaped, KeepsPrintableAndHidesTheRest) {
  EXPECT_EQ(escaped("{1,6}"), "{1,6}");
  EXPECT_EQ(escaped(std::string_view("a\x1b[2J\n\0\xff", 8)), "a\\x1b[2J\\x0a\\x00\\xff");
  EXPECT_EQ(escaped("\\"), "\\x5c");
}

TEST(Escaped, IsCut) {
  EXPECT_EQ(escaped(std::string(100, 'x'), 5), "xxxxx...");
}

TEST(Nearest, FindsTheTypoAndNothingFar) {
  const std::vector<std::string> known{"--speed", "--size", "--rules"};
  EXPECT_EQ(nearest("--sped", known), "--speed");
  EXPECT_EQ(nearest("--rulse", known), "--rules");
  EXPECT_FALSE(nearest("--zzzzzzzzzz", known).has_value());
  EXPECT_FALSE(nearest("x", {}).has_value());
}

TEST(Split, KeepsEmptyParts) {
  using Parts = std::vector<std::string_view>;
  EXPECT_EQ(split("1,5,", ','), (Parts{"1", "5", ""}));
  EXPECT_EQ(split(",a:b", ','), (Parts{"", "a:b"}));
  EXPECT_EQ(split("a:b", ':'), (Parts{"a", "b"}));
  EXPECT_EQ(split("", ','), Parts{""});
}

TEST(SystemReason, IsTheSystems) {
  EXPECT_EQ(system_reason(ENOENT), "No such file or directory");
}

TEST(AtPlace, LeavesOutWhatIsNotKnown) {
  EXPECT_EQ(at_place("a.txt", 3, 7, "bad"), "a.txt:3:7: bad");
  EXPECT_EQ(at_place("a.txt", 3, 0, "bad"), "a.txt:3: bad");
  EXPECT_EQ(at_place("a.txt", 0, 0, "bad"), "a.txt: bad");
}

TEST(Text, CountsThings) {
  EXPECT_EQ(counted(0, "client"), "0 clients");
  EXPECT_EQ(counted(1, "client"), "1 client");
  EXPECT_EQ(counted(2, "client"), "2 clients");
}

}  // namespace
}  // namespace aucast
