#include "client/face/classic_scanner.h"

#include <gtest/gtest.h>

namespace aucast::face {
namespace {

/// A scanner with the problems that it tells of.
struct Scanned {
  explicit Scanned(std::string_view text) : scanner(text, problems) {}

  /// What is wrong, after the name of the file; empty: nothing.
  [[nodiscard]] std::string complaint() const {
    const auto result = problems.result();
    return result ? std::string() : result.error().message.substr(std::string("f.dat").size());
  }

  Problems problems{"f.dat"};
  ClassicScanner scanner;
};

TEST(ClassicScanner, ReadsOverBlanksAndLineEnds) {
  Scanned one("\n 3 \t left_jaw\r\n\r\n-0.5\n");
  EXPECT_EQ(one.scanner.count("n", 0, 10), 3U);
  EXPECT_EQ(one.scanner.word("w"), "left_jaw");
  EXPECT_EQ(one.scanner.number("x"), -0.5F);
  one.scanner.end();
  EXPECT_EQ(one.complaint(), "");
}

TEST(ClassicScanner, KnowsWhereEachWordBegan) {
  Scanned one("12\n  345 6\n\n7");
  const std::pair<std::size_t, std::size_t> places[] = {{1, 1}, {2, 3}, {2, 7}, {4, 1}};
  for (const auto& [line, column] : places) {
    static_cast<void>(one.scanner.number("x"));
    EXPECT_EQ(one.scanner.place().line, line);
    EXPECT_EQ(one.scanner.place().column, column);
  }
}

TEST(ClassicScanner, ACountIsAWholeNumberWithinItsLimits) {
  for (const auto& [text, value] : {std::pair("3", 3U), std::pair("5", 5U), std::pair("4", 4U)}) {
    Scanned one(text);
    EXPECT_EQ(one.scanner.count("the number of points", 3, 5), value);
    EXPECT_EQ(one.complaint(), "");
  }
  const std::pair<const char*, const char*> wrong[] = {
      {"2", ":1:1: the number of points is 2, must be from 3 to 5"},
      {"6", ":1:1: the number of points is 6, must be from 3 to 5"},
      {"-3", ":1:1: the number of points is '-3', not a whole number"},
      {"4.0", ":1:1: the number of points is '4.0', not a whole number"},
      {"4x", ":1:1: the number of points is '4x', not a whole number"},
      {"99999999999999999999",
       ":1:1: the number of points is '99999999999999999999', not a whole number"},
      {" \n ", ":2:2: the file ends before the number of points"},
  };
  for (const auto& [text, complaint] : wrong) {
    Scanned one(text);
    EXPECT_EQ(one.scanner.count("the number of points", 3, 5), 0U) << text;
    EXPECT_EQ(one.complaint(), complaint);
  }
}

TEST(ClassicScanner, ANumberIsFiniteAndWithinItsBounds) {
  Scanned good("0 1 1e-3 -2.5E2");
  EXPECT_EQ(good.scanner.number("x", Bounds::between(0, 1)), 0.0F);
  EXPECT_EQ(good.scanner.number("x", Bounds::between(0, 1)), 1.0F);
  EXPECT_EQ(good.scanner.number("x", Bounds::above(0)), 0.001F);
  EXPECT_EQ(good.scanner.number("x"), -250.0F);
  EXPECT_EQ(good.complaint(), "");
  const std::pair<const char*, const char*> wrong[] = {
      {"0", ":1:1: the zone is 0, must be above 0 and below 90"},
      {"90", ":1:1: the zone is 90, must be above 0 and below 90"},
      {"nan", ":1:1: the zone is not a finite number"},
      {"-inf", ":1:1: the zone is not a finite number"},
      {"1,5", ":1:1: the zone is '1,5', not a number"},
      {"\x01", ":1:1: the zone is '\\x01', not a number"},
      {"", ":1:1: the file ends before the zone"},
  };
  for (const auto& [text, complaint] : wrong) {
    Scanned one(text);
    EXPECT_EQ(one.scanner.number("the zone", Bounds::inside(0, 90)), 0.0F) << text;
    EXPECT_EQ(one.complaint(), complaint);
  }
}

TEST(ClassicScanner, ANameHasAtMostSixtyFourPlainLetters) {
  const std::string longest(64, 'a');
  Scanned good(longest);
  EXPECT_EQ(good.scanner.word("the name"), longest);
  EXPECT_EQ(good.complaint(), "");
  for (const std::string& text :
       {longest + "a", std::string("caf\xc3\xa9"), std::string("a\x7f")}) {
    Scanned one(text);
    static_cast<void>(one.scanner.word("the name"));
    EXPECT_NE(one.complaint().find("must be plain text of at most 64 letters"), std::string::npos)
        << text;
  }
}

TEST(ClassicScanner, WhatComesAfterTheEndIsAWrongCount) {
  Scanned one("1\n2\n");
  static_cast<void>(one.scanner.number("x"));
  one.scanner.end();
  EXPECT_EQ(one.complaint(),
            ":2:1: the file should end here, but goes on with '2': is the count in its first line "
            "right?");
}

TEST(ClassicScanner, TheFirstProblemIsTheOneThatIsTold) {
  Scanned one("x y");
  static_cast<void>(one.scanner.number("the first"));
  static_cast<void>(one.scanner.number("the second"));
  one.scanner.wrong("something else");
  EXPECT_EQ(one.complaint(), ":1:1: the first is 'x', not a number");
}

}  // namespace
}  // namespace aucast::face
