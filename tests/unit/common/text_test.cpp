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

TEST(Printable, KeepsWhatPeopleWriteAndHidesWhatATerminalObeys) {
  for (const std::string_view text : {"/home/J\xc3\xb6rg/l\xc3\xa4"
                                      "cheln \xf0\x9f\x99\x82.txt",
                                      "a\\b", ""}) {
    EXPECT_EQ(printable(text), text);
  }
  EXPECT_EQ(printable("a\nb\x1b[2J\x7f"), "a\\x0ab\\x1b[2J\\x7f");
  EXPECT_EQ(printable("\xc2\x9b"
                      "2J"),
            "\\xc2\\x9b"
            "2J")
      << "the other escape of terminals";
  EXPECT_EQ(printable("\xff\xc0\x8a\xed\xa0\x80\xc3"), "\\xff\\xc0\\x8a\\xed\\xa0\\x80\\xc3");
}

TEST(Escaped, IsCut) {
  EXPECT_EQ(escaped(std::string(100, 'x'), 5), "xxxxx...");
}

TEST(LengthText, IsThatOfAClock) {
  EXPECT_EQ(length_text(Milliseconds(0)), "0:00");
  EXPECT_EQ(length_text(Milliseconds(1)), "0:01") << "there is something";
  EXPECT_EQ(length_text(Milliseconds(59'499)), "0:59");
  EXPECT_EQ(length_text(Milliseconds(59'500)), "1:00");
  EXPECT_EQ(length_text(Milliseconds(83'000)), "1:23");
  EXPECT_EQ(length_text(Milliseconds(3'723'000)), "1:02:03");
  EXPECT_EQ(length_text(Milliseconds(1'000'000'000'000)), "277777:46:40");
}

TEST(Nearest, FindsTheTypoAndNothingFar) {
  const std::vector<std::string> known{"--speed", "--size", "--rules"};
  EXPECT_EQ(nearest("--sped", known), "--speed");
  EXPECT_EQ(nearest("--rulse", known), "--rules");
  EXPECT_FALSE(nearest("--zzzzzzzzzz", known).has_value());
  EXPECT_FALSE(nearest("x", {}).has_value());
}

TEST(Nearest, OfAShortWordMostLettersAreRight) {
  const std::vector<std::string> known{"-v", "--fps", "facs"};
  EXPECT_FALSE(nearest("-o", known).has_value());
  EXPECT_FALSE(nearest("--foo", known).has_value());
  EXPECT_EQ(nearest("--fp", known), "--fps");
  EXPECT_EQ(nearest("fasc", known), "facs");
  EXPECT_EQ(nearest("--fsp", known), "--fps") << "letters that are swapped are one mistake";
  EXPECT_EQ(nearest("--pfs", known), "--fps");
  EXPECT_FALSE(nearest("--spf", known).has_value()) << "and these are two";
  EXPECT_EQ(nearest("-v", known), "-v");
}

TEST(Split, KeepsEmptyParts) {
  using Parts = std::vector<std::string_view>;
  EXPECT_EQ(split("1,5,", ','), (Parts{"1", "5", ""}));
  EXPECT_EQ(split(",a:b", ','), (Parts{"", "a:b"}));
  EXPECT_EQ(split("a:b", ':'), (Parts{"a", "b"}));
  EXPECT_EQ(split("", ','), Parts{""});
}

TEST(SplitWords, LeavesOutBlanks) {
  using Words = std::vector<std::string_view>;
  EXPECT_EQ(split_words("au  12 sided\r"), (Words{"au", "12", "sided"}));
  EXPECT_EQ(split_words("\t a\t"), Words{"a"});
  EXPECT_TRUE(split_words(" \t\r").empty());
  EXPECT_TRUE(split_words("").empty());
}

TEST(Lowered, TouchesAsciiCapitalsOnly) {
  EXPECT_EQ(lowered("Left_LABI 9@[`{\xC3\x84"), "left_labi 9@[`{\xC3\x84");
}

TEST(SystemReason, IsTheSystems) {
  EXPECT_EQ(system_reason(ENOENT), "No such file or directory");
}

TEST(AtPlace, LeavesOutWhatIsNotKnown) {
  EXPECT_EQ(at_place("a.txt", 3, 7, "bad"), "a.txt:3:7: bad");
  EXPECT_EQ(at_place("a.txt", 3, 0, "bad"), "a.txt:3: bad");
  EXPECT_EQ(at_place("a.txt", 0, 0, "bad"), "a.txt: bad");
  EXPECT_EQ(at_place("a\n.txt", "bad"), "a\\x0a.txt: bad");
}

TEST(Text, CountsThings) {
  EXPECT_EQ(counted(0, "client"), "0 clients");
  EXPECT_EQ(counted(1, "client"), "1 client");
  EXPECT_EQ(counted(2, "client"), "2 clients");
}

}  // namespace
}  // namespace aucast
