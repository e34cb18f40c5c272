#include "common/sources/arkit_table.h"

#include <gtest/gtest.h>

#include "common/files.h"

namespace aucast::sources {
namespace {

constexpr const char* kHeader = "curve,au,side,gain\n";

std::string message(const std::string& rows) {
  const auto table = parse_arkit_table(kHeader + rows, "t.csv");
  return table ? "accepted" : table.error().message;
}

TEST(ArkitTable, ReadsCurves) {
  const auto table =
      parse_arkit_table(std::string(kHeader) + "jawOpen,26,B,1\neyeBlinkLeft,45,L,1.5\n", "t.csv");
  ASSERT_TRUE(table);
  ASSERT_EQ(table->curves.size(), 2U);
  EXPECT_EQ(table->curves[0].curve, "jawOpen");
  EXPECT_EQ(table->curves[1].number, 45);
  EXPECT_EQ(table->curves[1].side, Side::Left);
  EXPECT_EQ(table->curves[1].gain, 1.5);
}

TEST(ArkitTable, EveryWrongCellIsRefusedWhereItStands) {
  EXPECT_EQ(message("jawOpen,0,B,1\n"), "t.csv:2:9: expected an AU from 1 to 99");
  EXPECT_EQ(message("jawOpen,100,B,1\n"), "t.csv:2:9: expected an AU from 1 to 99");
  EXPECT_EQ(message("jawOpen,2.5,B,1\n"), "t.csv:2:9: expected an AU from 1 to 99");
  EXPECT_EQ(message("jawOpen,26,X,1\n"), "t.csv:2:12: 'X' is no side; write L, R or B");
  EXPECT_EQ(message("jawOpen,26,B,0\n"), "t.csv:2:14: expected a gain above 0, at most 10");
  EXPECT_EQ(message("jawOpen,26,B,11\n"), "t.csv:2:14: expected a gain above 0, at most 10");
  EXPECT_EQ(message("jawOpen,26,B\n"), "t.csv:2:1: the row has 3 cells, the header names 4");
  const auto header = parse_arkit_table("curve,au\njawOpen,26\n", "t.csv");
  ASSERT_FALSE(header);
  EXPECT_EQ(header.error().message, "t.csv:1:1: expected the columns curve, au, side and gain");
}

TEST(ArkitTable, TheOneWeShipIsRightAndKeepsTheSubjectsSides) {
  const auto data = find_data_folder({});
  ASSERT_TRUE(data);
  const auto text = read_file(*data / "sources" / "arkit_to_au.csv");
  ASSERT_TRUE(text);
  const auto table = parse_arkit_table(*text, "arkit_to_au.csv");
  ASSERT_TRUE(table) << table.error().message;
  EXPECT_GE(table->curves.size(), 40U);
  for (const ArkitCurve& curve : table->curves) {
    if (curve.number >= 61 && curve.number <= 64) continue;  // of one eye each, by its own side
    if (curve.curve.ends_with("Left")) {
      EXPECT_EQ(curve.side, Side::Left) << curve.curve;
    }
    if (curve.curve.ends_with("Right")) {
      EXPECT_EQ(curve.side, Side::Right) << curve.curve;
    }
  }
}

}  // namespace
}  // namespace aucast::sources
