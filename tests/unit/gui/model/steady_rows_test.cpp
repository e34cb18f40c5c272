#include "client/gui/model/steady_rows.h"

#include <gtest/gtest.h>

namespace aucast::gui {
namespace {

std::vector<std::string> labels(const std::vector<AuRow>& rows) {
  std::vector<std::string> all;
  for (const AuRow& row : rows) all.push_back(row.label);
  return all;
}

using Labels = std::vector<std::string>;

TEST(SteadyRows, AnAuThatTheStreamHasHadKeepsItsRow) {
  SteadyRows steady;
  steady.with({{"6", "Cheek Raiser", 40, 40, ""}, {"12", "Lip Corner Puller", 80, 80, ""}}, "a");
  const auto& rows = steady.with({{"12", "Lip Corner Puller", 20, 10, ""}}, "a");
  EXPECT_EQ(labels(rows), (Labels{"6", "12"}));
  EXPECT_EQ(rows[0].received_percent + rows[0].shown_percent, 0);
  EXPECT_EQ(rows[0].name, "Cheek Raiser");
  EXPECT_EQ(rows[1].shown_percent, 10);
  EXPECT_EQ(steady.with({}, "a").size(), 2U) << "a neutral keyframe";
}

TEST(SteadyRows, ANewOneComesInOrder) {
  SteadyRows steady;
  steady.with({{"R14", "", 1, 1, ""}, {"51", "", 1, 1, ""}}, "a");
  const auto& rows = steady.with(
      {{"4", "", 1, 1, ""}, {"12", "", 1, 1, ""}, {"L14", "", 1, 1, ""}, {"14", "", 1, 1, ""}},
      "a");
  EXPECT_EQ(labels(rows), (Labels{"4", "12", "14", "L14", "R14", "51"}));
}

TEST(SteadyRows, TheRoomForARuleStays) {
  SteadyRows steady;
  steady.with({{"51", "", 100, 60, "opposition"}}, "a");
  const auto& rows = steady.with({{"51", "", 100, 100, ""}}, "a");
  EXPECT_EQ(rows[0].why, "");
  EXPECT_TRUE(rows[0].room_for_why);
}

TEST(SteadyRows, OfAnotherStreamTheyBeginAnew) {
  SteadyRows steady;
  steady.with({{"6", "", 40, 40, ""}}, "a");
  EXPECT_EQ(labels(steady.with({{"12", "", 1, 1, ""}}, "b")), Labels{"12"});
}

}  // namespace
}  // namespace aucast::gui
