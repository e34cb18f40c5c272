#include "common/sources/line_splitter.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace aucast::sources {
namespace {

/// "3:text" for each line of what comes in these pieces.
std::vector<std::string> lines_of(const std::vector<std::string_view>& pieces) {
  LineSplitter splitter(100);
  std::vector<std::string> lines;
  for (const std::string_view piece : pieces) {
    splitter.feed(piece);
    while (const auto line = splitter.next()) {
      lines.push_back(std::to_string(line->number) + ":" + line->text);
    }
  }
  return lines;
}

TEST(LineSplitter, TakesEveryEndOfALineCutAnywhere) {
  constexpr std::string_view kText = "a\r\nb\rc\n\r\nd\r\n";
  const std::vector<std::string> wanted{"1:a", "2:b", "3:c", "4:", "5:d"};
  EXPECT_EQ(lines_of({kText}), wanted);
  for (std::size_t cut = 0; cut <= kText.size(); ++cut) {
    EXPECT_EQ(lines_of({kText.substr(0, cut), kText.substr(cut)}), wanted) << cut;
  }
}

TEST(LineSplitter, GivesALineThatIsTooLongOnceBeforeItEnds) {
  LineSplitter splitter(4);
  splitter.feed("abc");
  EXPECT_FALSE(splitter.next());
  splitter.feed("de");
  const auto line = splitter.next();
  ASSERT_TRUE(line);
  EXPECT_TRUE(line->too_long);
  EXPECT_EQ(line->text, "abcd");
  EXPECT_FALSE(splitter.next());
  const std::string rest(100, 'x');
  splitter.feed(rest);
  EXPECT_FALSE(splitter.next()) << "it was given already";
  splitter.feed("\r\nabcd\nabcde\n");
  EXPECT_FALSE(splitter.next()->too_long);
  const auto next = splitter.next();
  ASSERT_TRUE(next);
  EXPECT_TRUE(next->too_long);
  EXPECT_EQ(next->number, 3U);
  EXPECT_FALSE(splitter.next());
}

TEST(LineSplitter, AnotherFileBeginsWithItsFirstLine) {
  LineSplitter splitter(100);
  splitter.feed("a\r");
  ASSERT_TRUE(splitter.next());
  EXPECT_FALSE(splitter.next());
  splitter.restart();
  splitter.feed("\nb\n");
  const auto empty = splitter.next();
  ASSERT_TRUE(empty);
  EXPECT_EQ(empty->text, "");
  EXPECT_EQ(empty->number, 1U);
}

}  // namespace
}  // namespace aucast::sources
