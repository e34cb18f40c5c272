#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "scripts/facegen/polyline.h"

namespace aucast::facegen {
namespace {

/// 3 to the right, then 4 up; its strength grows from 0 over 1 to 0.5.
constexpr std::array<Vec3, 3> kCorner{{{0, 0, 0}, {3, 0, 1}, {3, 4, 0.5}}};

TEST(Polyline, FindsTheNearestPlaceAndItsSide) {
  const Polyline line(kCorner);
  const auto below = line.nearest({1.5, -2});
  EXPECT_DOUBLE_EQ(below.along(), 0.5);
  EXPECT_DOUBLE_EQ(below.away, 2);
  EXPECT_DOUBLE_EQ(below.to_left, -2);
  const auto inside = line.nearest({2.5, 3});
  EXPECT_EQ(inside.piece, 1U);
  EXPECT_DOUBLE_EQ(inside.along(), 1.75);
  EXPECT_DOUBLE_EQ(inside.away, 0.5);
  EXPECT_DOUBLE_EQ(inside.to_left, 0.5);
  const auto beyond = line.nearest({3, 9});
  EXPECT_DOUBLE_EQ(beyond.along(), 2);
  EXPECT_DOUBLE_EQ(beyond.away, 5);
}

TEST(Polyline, ItsStrengthIsThatOfTheLineAndFallsOffBeside) {
  const Polyline line(kCorner);
  EXPECT_DOUBLE_EQ(line.strength({3, 0}, 0.2), 1);
  EXPECT_DOUBLE_EQ(line.strength({3, 2}, 0.2), 0.75);
  EXPECT_NEAR(line.strength({3.2, 2}, 0.2), 0.75 * std::exp(-1), 1e-12);
  EXPECT_NEAR(line.strength({3, 4.2}, 0.2), 0.5 * std::exp(-1), 1e-12) << "past its end";
  // The piece that is nearest here is nothing, the other one is strong.
  const std::array<Vec3, 3> fading{{{0, 1, 1}, {0, 0, 0}, {2, 0, 0}}};
  EXPECT_EQ(Polyline(fading).nearest({1, 0.5}).piece, 1U);
  EXPECT_NEAR(Polyline(fading).strength({1, 0.5}, 1), 0.5 * std::exp(-1), 1e-12);
}

TEST(Polyline, IsMeasuredInItsOwnSpace) {
  const std::vector<glm::dvec2> flat{{0, 0}, {3, 0}, {3, 4}};
  EXPECT_DOUBLE_EQ(Polyline(flat).length(), 7);
  const std::array<Vec3, 2> rising{{{1, 0, 0}, {1, 3, 4}}};
  EXPECT_DOUBLE_EQ(Polyline(rising).length(), 5);
}

TEST(Polyline, IsWalkedByLength) {
  const std::vector<glm::dvec2> flat{{0, 0}, {3, 0}, {3, 4}};
  const Polyline line(flat);
  EXPECT_EQ(line.at_length(-1), flat.front());
  EXPECT_EQ(line.at_length(1.5), glm::dvec2(1.5, 0));
  EXPECT_EQ(line.at_length(3), flat[1]);
  EXPECT_EQ(line.at_length(6), glm::dvec2(3, 3));
  EXPECT_EQ(line.at_length(8), flat.back());
}

TEST(Polyline, ItsCurveMeetsEveryPointAtItsShare) {
  const std::vector<glm::dvec2> flat{{0, 0}, {3, 0}, {3, 4}};
  const Polyline line(flat);
  EXPECT_EQ(line.along(0), flat[0]);
  EXPECT_EQ(line.along(0.5), flat[1]);
  EXPECT_EQ(line.along(1), flat[2]);
  // Smooth: it has left the straight piece before the corner.
  EXPECT_LT(line.along(0.4).y, -0.05);
  const std::vector<glm::dvec2> straight{{0, 0}, {1, 2}, {2, 4}};
  const glm::dvec2 on = Polyline(straight).along(0.3);
  EXPECT_DOUBLE_EQ(on.x, 0.6);
  EXPECT_DOUBLE_EQ(on.y, 1.2);
}

}  // namespace
}  // namespace aucast::facegen
