#include "common/sources/csv_reader.h"

#include <algorithm>
#include <deque>

#include <gtest/gtest.h>

namespace aucast::sources {
namespace {

using Next = CsvReader::Next;

/// The reader refers to its text, so that is kept.
CsvReader opened(std::string_view text) {
  static std::deque<std::string> texts;
  auto reader = CsvReader::open(texts.emplace_back(text), "f.csv");
  EXPECT_TRUE(reader) << (reader ? "" : reader.error().message);
  return std::move(*reader);
}

/// The only row of a table with the columns a and b.
CsvReader at_row(std::string_view text) {
  CsvReader reader = opened(text);
  EXPECT_EQ(reader.next(), Next::Row);
  return reader;
}

TEST(CsvReader, FindsColumnsByNameWithBlanksAroundThem) {
  const CsvReader reader = opened("frame, timestamp ,\tx_0, X_0\n");
  EXPECT_EQ(reader.columns(), (std::vector<std::string>{"frame", "timestamp", "x_0", "X_0"}));
  EXPECT_EQ(reader.column("X_0"), 3U);
  EXPECT_EQ(reader.column("x_0"), 2U);
  EXPECT_FALSE(reader.column("y_0"));
}

TEST(CsvReader, TakesByteOrderMarkCrlfAndBlankLines) {
  CsvReader reader = opened("\xef\xbb\xbf\r\na,b\r\n\r\n1,2\r\n  \r\n3,4");
  EXPECT_EQ(reader.columns().front(), "a");
  ASSERT_EQ(reader.next(), Next::Row);
  EXPECT_EQ(reader.number(1), 2);
  EXPECT_EQ(reader.line(), 4U);
  ASSERT_EQ(reader.next(), Next::Row);
  EXPECT_EQ(reader.number(0), 3);
  EXPECT_EQ(reader.next(), Next::End);
  EXPECT_EQ(reader.next(), Next::End);
  EXPECT_FALSE(reader.has_errors());
}

TEST(CsvReader, TakesSemicolonsTabsAndQuotes) {
  CsvReader semicolons = at_row("a;b\n0,5;1\n");
  EXPECT_EQ(semicolons.number(0), 0.5);
  CsvReader tabs = at_row("a\tb\n1\t2\n");
  EXPECT_EQ(tabs.number(1), 2);
  CsvReader quotes = at_row("\"a\",\"b\"\n\"0,75\",\"1,234.5\"\n");
  EXPECT_EQ(quotes.number(quotes.column("a")), 0.75);
  EXPECT_EQ(quotes.number(quotes.column("b")), 1234.5);
}

TEST(CsvReader, EveryWordForNoDataIsNoData) {
  for (const char* word : {"", " ", "nan", "NaN", "-nan", "-nan(ind)", "inf", "-Inf", "NA", "N/A",
                           "null", "None", "\"\""}) {
    CsvReader reader = at_row(std::string("a,b\n") + word + ",1\n");
    EXPECT_FALSE(reader.number(0)) << word;
    EXPECT_FALSE(reader.has_errors()) << word;
  }
  CsvReader reader = at_row("a,b\n1,2\n");
  EXPECT_FALSE(reader.number(std::nullopt)) << "a column that is not there";
}

TEST(CsvReader, WhatIsNoNumberIsRefusedWhereItStands) {
  for (const char* word : {"x", "1x", "0x10", "1e999", "--1", "1 2"}) {
    CsvReader reader = at_row("a, b\n1, " + std::string(word) + "\n");
    EXPECT_FALSE(reader.number(1)) << word;
    EXPECT_EQ(reader.error().kind, ErrorKind::BadData);
    EXPECT_EQ(reader.error().message,
              "f.csv:2:4: '" + std::string(word) + "' in b is not a number");
  }
}

TEST(CsvReader, NumbersWithCommas) {
  EXPECT_EQ(parse_number("1.5", false), 1.5);
  EXPECT_EQ(parse_number("+1.5", false), 1.5);
  EXPECT_EQ(parse_number("-1e-3", false), -0.001);
  EXPECT_EQ(parse_number("1,5", true), 1.5);
  EXPECT_EQ(parse_number("1,234,567", true), 1234567);
  EXPECT_EQ(parse_number("12,345.25", true), 12345.25);
  EXPECT_FALSE(parse_number("1,5", false));
  EXPECT_FALSE(parse_number("1,23,4", true));
  EXPECT_FALSE(parse_number("1,2345.6", true));
  EXPECT_FALSE(parse_number("1.234,5", true));
  EXPECT_FALSE(parse_number("", true));
  EXPECT_FALSE(parse_number("nan", true));
}

TEST(CsvReader, RowsOfTheWrongLengthAreRefused) {
  CsvReader reader = opened("a,b,c\n1,2\n1,2,3,4\n1,2,3\n");
  EXPECT_EQ(reader.next(), Next::Faulty);
  EXPECT_EQ(reader.next(), Next::Faulty);
  EXPECT_EQ(reader.next(), Next::Row);
  EXPECT_EQ(reader.error().message,
            "f.csv:2:1: the row has 2 cells, the header names 3\n"
            "f.csv:3:1: the row has 4 cells, the header names 3; numbers with commas must be "
            "quoted, or the cells separated by ';'");
}

TEST(CsvReader, TruncatedLastLineIsNoError) {
  CsvReader reader = opened("a,b,c\n1,2,3\n4,5");
  EXPECT_EQ(reader.next(), Next::Row);
  EXPECT_EQ(reader.next(), Next::Truncated);
  EXPECT_EQ(reader.next(), Next::End);
  EXPECT_FALSE(reader.has_errors());
}

TEST(CsvReader, RepeatedHeaderIsKnown) {
  CsvReader reader = opened("a, b\r\n1,2\na, b\n3,4\n");
  EXPECT_EQ(reader.next(), Next::Row);
  EXPECT_EQ(reader.next(), Next::RepeatedHeader);
  EXPECT_EQ(reader.next(), Next::Row);
}

TEST(CsvReader, RewindsToTheFirstRow) {
  CsvReader reader = opened("\na,b\n1,2\n3,4\n");
  while (reader.next() != Next::End) {
  }
  reader.rewind();
  ASSERT_EQ(reader.next(), Next::Row);
  EXPECT_EQ(reader.number(0), 1);
  EXPECT_EQ(reader.line(), 3U);
}

TEST(CsvReader, EmptyTextsAndLongLinesAreRefused) {
  for (const char* text : {"", "\n", "\xef\xbb\xbf", " \r\n\n"}) {
    const auto reader = CsvReader::open(text, "f.csv");
    ASSERT_FALSE(reader);
    EXPECT_NE(reader.error().message.find("the file holds nothing"), std::string::npos);
  }
  const std::string wide(kCsvLineBytesMax + 1, 'x');
  const auto header = CsvReader::open(wide, "f.csv");
  ASSERT_FALSE(header);
  EXPECT_EQ(header.error().message, "f.csv:1:262145: the line is longer than 262144 bytes");
  CsvReader row = opened("a,b\n" + wide + "\n");
  EXPECT_EQ(row.next(), Next::Faulty);
  const auto columns = CsvReader::open(std::string(kCsvColumnsMax + 1, ','), "f.csv");
  ASSERT_FALSE(columns);
  EXPECT_EQ(columns.error().message, "f.csv:1:1: more than 8192 columns");
}

TEST(CsvReader, ReportsTwentyErrorsAndCountsTheRest) {
  std::string text = "a,b\n";
  for (int row = 0; row < 25; ++row) text += "1\n";
  CsvReader reader = opened(text);
  while (reader.next() != Next::End) {
  }
  const std::string message = reader.error().message;
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 20);
  EXPECT_TRUE(message.ends_with("\nf.csv: and 5 more errors")) << message;
}

}  // namespace
}  // namespace aucast::sources
