#include "client/view/rounded_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace aucast::view {
namespace {

using Triangle = RoundedMesh::Triangle;

/// An octahedron in a ball of radius 2: as coarse as a closed mesh can well be.
class Octahedron : public testing::Test {
 protected:
  static constexpr float kRadius = 2;

  void SetUp() override {
    for (const glm::vec3& n : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(-1, 0, 0),
                               glm::vec3(0, -1, 0), glm::vec3(0, 0, 1), glm::vec3(0, 0, -1)}) {
      normals_.push_back(n);
      positions_.push_back(n * kRadius);
    }
    for (std::uint32_t i = 0; i < 4; ++i) {
      triangles_.push_back({i, (i + 1) % 4, 4});
      triangles_.push_back({(i + 1) % 4, i, 5});
    }
    rounded_ = RoundedMesh(positions_, triangles_, 0);
    rounded_.place(positions_, normals_);
  }

  std::vector<glm::vec3> positions_;
  std::vector<glm::vec3> normals_;
  std::vector<Triangle> triangles_;
  RoundedMesh rounded_;
};

TEST(RoundedMesh, OfNothingIsNothing) {
  RoundedMesh rounded;
  rounded.place({}, {});
  EXPECT_TRUE(rounded.triangles().empty());
  EXPECT_TRUE(rounded.positions().empty());
}

TEST_F(Octahedron, LeavesTheOwnVerticesWhereTheyAre) {
  ASSERT_EQ(rounded_.vertex_count(), 6U + 12U);
  EXPECT_TRUE(std::equal(positions_.begin(), positions_.end(), rounded_.positions().begin()));
  EXPECT_TRUE(std::equal(normals_.begin(), normals_.end(), rounded_.normals().begin()));
}

TEST_F(Octahedron, MovesTheMiddlesTowardsTheBall) {
  // A quarter of a circle: from its chord at 0.71 of the radius to 0.88, five eighths of the way.
  const float arch = 0.625F * std::numbers::sqrt2_v<float> * kRadius;
  for (std::size_t i = 6; i < rounded_.vertex_count(); ++i) {
    const glm::vec3& p = rounded_.positions()[i];
    EXPECT_NEAR(glm::length(p), arch, 1e-5) << i;
    EXPECT_NEAR(glm::length(rounded_.normals()[i] - glm::normalize(p)), 0, 1e-5) << i;
  }
}

TEST_F(Octahedron, StaysClosedAndTurnedOutwards) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  ASSERT_EQ(rounded_.triangles().size(), 4 * triangles_.size());
  for (const auto& [a, b, c] : rounded_.triangles()) {
    const auto at = [this](std::uint32_t i) { return rounded_.positions()[i]; };
    EXPECT_GT(glm::dot(glm::cross(at(b) - at(a), at(c) - at(a)), at(a) + at(b) + at(c)), 0);
    for (const auto& edge : {std::pair{a, b}, {b, c}, {c, a}}) ++edges[edge];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1) << edge.first << "-" << edge.second;
    EXPECT_TRUE(edges.contains({edge.second, edge.first})) << edge.first << "-" << edge.second;
  }
}

TEST_F(Octahedron, GivesTheMiddlesTheMeanOfTheirEnds) {
  const std::vector<float> values{0, 1, 2, 3, 4, 5};
  const auto all = rounded_.with_edges(std::span<const float>(values));
  ASSERT_EQ(all.size(), rounded_.vertex_count());
  EXPECT_EQ(all[3], 3);
  // The first triangle is 0, 1, 4; its first quarter holds the middles of 0-1 and 4-0.
  const auto [corner, along, back] = rounded_.triangles()[0];
  EXPECT_EQ(corner, 0U);
  EXPECT_EQ(all[along], 0.5F);
  EXPECT_EQ(all[back], 2);
}

TEST_F(Octahedron, LeavesTrianglesThatHardlyBend) {
  const RoundedMesh coarse(positions_, triangles_, 0.6F);
  EXPECT_EQ(coarse.vertex_count(), 6U);
  EXPECT_TRUE(std::equal(triangles_.begin(), triangles_.end(), coarse.triangles().begin(),
                         coarse.triangles().end()));
  EXPECT_EQ(coarse.rounded_count(8), 8U);
}

/// A strip with a fold along one edge: triangles with every number of edges that bend must still
/// fit together.
TEST(RoundedMesh, FitsTogetherWhereOnlySomeEdgesBend) {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
  constexpr std::uint32_t kAlong = 7;
  for (std::uint32_t i = 0; i < kAlong; ++i) {
    const float angle = i < 3 ? 0.0F : 0.5F * static_cast<float>(i - 2);
    for (std::uint32_t j = 0; j < kAlong; ++j) {
      positions.emplace_back(std::sin(angle) * 2 + static_cast<float>(std::min(i, 2U)),
                             static_cast<float>(j), 2 * std::cos(angle));
      if (i == 0 || j == 0) continue;
      const std::uint32_t at = i * kAlong + j;
      triangles.push_back({at - kAlong - 1, at - 1, at});
      triangles.push_back({at - kAlong - 1, at, at - kAlong});
    }
  }
  RoundedMesh rounded(positions, triangles, 0.02F);
  std::map<std::size_t, int> became;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    ++became[rounded.rounded_count(i + 1) - rounded.rounded_count(i)];
  }
  EXPECT_GT(became[1], 0);
  EXPECT_GT(became[2] + became[3], 0);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& [a, b, c] : rounded.triangles()) {
    for (const auto& edge : {std::pair{a, b}, {b, c}, {c, a}}) ++edges[edge];
  }
  // Within the strip every edge has its other half: no vertex stands on the middle of another edge.
  rounded.place(positions, std::vector<glm::vec3>(positions.size(), glm::vec3(0, 0, 1)));
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    if (edges.contains({edge.second, edge.first})) continue;
    const glm::vec3 middle =
        (rounded.positions()[edge.first] + rounded.positions()[edge.second]) * 0.5F;
    const bool on_border = middle.y < 1e-4F || middle.y > kAlong - 1 - 1e-4F || middle.x < 1e-4F ||
                           edge.first >= (kAlong - 1) * kAlong;
    EXPECT_TRUE(on_border) << edge.first << "-" << edge.second;
  }
}

TEST(RoundedMesh, KeepsAPlaneFlat) {
  const std::vector<glm::vec3> positions{{0, 0, 1}, {2, 0, 1}, {0, 3, 1}};
  const std::vector<glm::vec3> normals(3, glm::vec3(0, 0, 1));
  const std::vector<Triangle> triangles{{0, 1, 2}};
  RoundedMesh rounded(positions, triangles, 0);
  rounded.place(positions, normals);
  for (const glm::vec3& p : rounded.positions()) EXPECT_EQ(p.z, 1);
  for (const glm::vec3& n : rounded.normals()) EXPECT_EQ(n, glm::vec3(0, 0, 1));
}

TEST(RoundedMesh, StaysFiniteWhereAnEdgeHasNoLength) {
  const std::vector<glm::vec3> positions{{1, 1, 1}, {1, 1, 1}, {1, 2, 1}};
  const std::vector<glm::vec3> normals{{0, 0, 1}, {0, 0, -1}, {0, 0, 1}};
  const std::vector<Triangle> triangles{{0, 1, 2}};
  RoundedMesh rounded(positions, triangles, 0);
  rounded.place(positions, normals);
  for (const auto& values : {rounded.positions(), rounded.normals()}) {
    for (const glm::vec3& v : values) {
      EXPECT_TRUE(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z));
    }
  }
}

}  // namespace
}  // namespace aucast::view
