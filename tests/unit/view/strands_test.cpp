#include "client/view/strands.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace aucast::view {
namespace {

using Corners = std::array<std::uint32_t, 3>;

/// A square seen from +z and beside it a triangle of skin; the numbers grow along `across`.
struct Patch {
  std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                   {5, 0, 0}, {6, 0, 0}, {6, 1, 0}};
  std::vector<Corners> triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}};
  std::vector<MaterialRange> ranges{{{.shader = Shader::Hair}, 0, 2}, {{}, 2, 1}};
  std::vector<float> numbers;

  explicit Patch(const glm::vec3& across) {
    for (const glm::vec3& p : positions) numbers.push_back(glm::dot(p, across));
  }
  [[nodiscard]] StaticMesh mesh() const {
    StaticMesh mesh;
    mesh.triangles = triangles;
    mesh.ranges = ranges;
    mesh.strand = numbers;
    return mesh;
  }
};

void expect_way(const glm::vec4& strand, const glm::vec3& expected) {
  const glm::vec3 way = glm::normalize(glm::vec3(strand));
  EXPECT_NEAR(glm::distance(way, glm::normalize(expected)), 0, 1e-5F)
      << way.x << " " << way.y << " " << way.z;
}

TEST(Strands, HangDownWhereTheirNumberGrowsToTheRight) {
  const Patch patch({0.1F, 0, 0});
  Strands strands(patch.mesh(), patch.positions.size());
  const auto ways = strands.place(patch.positions);
  ASSERT_EQ(ways.size(), patch.positions.size());
  for (std::size_t i = 0; i < 4; ++i) {
    expect_way(ways[i], {0, -1, 0});
    EXPECT_FLOAT_EQ(ways[i].w, patch.numbers[i]);
  }
}

TEST(Strands, LieWhereTheirNumberDoesNotChange) {
  const Patch patch({0.1F, 0.2F, 0});
  Strands strands(patch.mesh(), patch.positions.size());
  for (std::size_t i = 0; i < 4; ++i) expect_way(strands.place(patch.positions)[i], {2, -1, 0});
}

TEST(Strands, GoWithTheMesh) {
  Patch patch({0.1F, 0, 0});
  Strands strands(patch.mesh(), patch.positions.size());
  for (int frame = 0; frame < 2; ++frame) {  // nothing is left of the frame before
    for (glm::vec3& p : patch.positions) p = {p.y, p.z, p.x};
    const auto ways = strands.place(patch.positions);
    for (std::size_t i = 0; i < 4; ++i) {
      expect_way(ways[i], frame == 0 ? glm::vec3(-1, 0, 0) : glm::vec3(0, 0, -1));
    }
  }
}

TEST(Strands, AreOnHairAlone) {
  const Patch patch({0.1F, 0, 0});
  Strands strands(patch.mesh(), patch.positions.size() + 2);  // and two made for rounding
  const auto ways = strands.place(patch.positions);
  ASSERT_EQ(ways.size(), patch.positions.size() + 2);
  for (std::size_t i = 4; i < ways.size(); ++i) EXPECT_EQ(glm::vec3(ways[i]), glm::vec3(0));
}

TEST(Strands, OfAFaceWithoutAnyAreNothing) {
  Patch patch({0.1F, 0, 0});
  patch.numbers.clear();
  Strands strands(patch.mesh(), patch.positions.size());
  for (const glm::vec4& way : strands.place(patch.positions)) EXPECT_EQ(way, glm::vec4(0));
}

}  // namespace
}  // namespace aucast::view
