#include "client/gui/model/row_places.h"

#include <gtest/gtest.h>

namespace aucast::gui {
namespace {

const std::vector<RowPlace> kBefore{{1, 0}, {2, 20}, {3, 40}, {4, 60}};

TEST(RowPlaces, ARowMovesByWhatComesAboveIt) {
  const std::vector<RowPlace> now{{1, 0}, {9, 20}, {2, 35}, {3, 55}, {4, 75}};
  EXPECT_EQ(moved_down(kBefore, now, 10), 0) << "above the new one";
  EXPECT_EQ(moved_down(kBefore, now, 45), 15);
}

TEST(RowPlaces, WhatGoesBelowMovesNothing) {
  EXPECT_EQ(moved_down(kBefore, {{1, 0}, {2, 20}, {3, 40}}, 45), 0);
}

TEST(RowPlaces, OfARowThatIsGoneTheOneAboveTells) {
  EXPECT_EQ(moved_down(kBefore, {{1, 0}, {2, 12}, {4, 40}}, 45), -8);
  EXPECT_EQ(moved_down(kBefore, {}, 45), 0);
}

TEST(RowPlaces, RowsOfOneNameTellNothing) {
  EXPECT_EQ(moved_down({{1, 0}, {2, 20}, {2, 40}}, {{1, 0}, {2, 30}, {2, 50}}, 45), 0);
  EXPECT_EQ(moved_down({{1, 0}, {2, 20}}, {{1, 0}, {2, 30}, {2, 50}}, 25), 0);
}

}  // namespace
}  // namespace aucast::gui
