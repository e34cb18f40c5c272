#include "client/face/normal_field.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/support/seeded.h"

namespace aucast::face {
namespace {

using aucast::test::Seeded;

/// The definition: each triangle gives its area to its corners.
std::vector<glm::dvec3> plain_sums(const FaceMesh& mesh) {
  std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0));
  const auto at = [&](std::uint32_t i) { return glm::dvec3(mesh.positions[i]); };
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::dvec3 area = glm::cross(at(b) - at(a), at(c) - at(a));
    for (const std::uint32_t corner : {a, b, c}) sums[corner] += area;
  }
  return sums;
}

/// All normals of the mesh as it stands, its field made with other positions and moved here.
std::vector<glm::vec3> normals_of(const FaceMesh& mesh) {
  FaceMesh elsewhere = mesh;
  for (glm::vec3& position : elsewhere.positions) position = -2.0F * position;
  NormalField field(elsewhere);
  const std::vector<VertexBlock> blocks = blocks_of(mesh.positions);
  BlockSet moved(blocks.size());
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    field.place(block, points_of(blocks[block]));
    moved.insert(block);
  }
  std::vector<glm::vec3> normals(mesh.positions.size());
  field.update(moved, normals);
  return normals;
}

void expect_plain_normals(const FaceMesh& mesh) {
  const auto normals = normals_of(mesh);
  const auto sums = plain_sums(mesh);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double length = glm::length(sums[i]);
    const glm::dvec3 expected = length > 0 ? sums[i] / length : glm::dvec3(0, 0, 1);
    EXPECT_LT(glm::distance(glm::dvec3(normals[i]), expected), 1e-5 + 1e-5 / length)
        << "vertex " << i;
  }
}

FaceMesh mesh_of(std::vector<glm::vec3> positions,
                 std::vector<std::array<std::uint32_t, 3>> triangles) {
  FaceMesh mesh;
  mesh.positions = std::move(positions);
  mesh.triangles = std::move(triangles);
  return mesh;
}

/// A middle at height 1 over a ring of n corners, and another at -1 below it.
std::vector<glm::vec3> ring(std::size_t n) {
  std::vector<glm::vec3> positions{{0, 0, 1}, {0, 0, -1}};
  for (std::size_t i = 0; i < n; ++i) {
    const float angle = 6.2831853F * static_cast<float>(i) / static_cast<float>(n);
    positions.emplace_back(2 * std::cos(angle), std::sin(angle), 0.1F * static_cast<float>(i % 3));
  }
  return positions;
}

TEST(NormalField, AVertexWithinItsTrianglesWhateverTheirNumber) {
  for (std::uint32_t n = 3; n < 12; ++n) {
    FaceMesh mesh = mesh_of(ring(n), {});
    for (std::uint32_t i = 0; i < n; ++i) mesh.triangles.push_back({0, 2 + i, 2 + (i + 1) % n});
    SCOPED_TRACE(n);
    expect_plain_normals(mesh);
  }
}

TEST(NormalField, AVertexAtTheEdgeOfItsTriangles) {
  for (std::uint32_t n = 1; n < 9; ++n) {
    FaceMesh mesh = mesh_of(ring(n + 1), {});
    for (std::uint32_t i = 0; i < n; ++i) mesh.triangles.push_back({0, 2 + i, 3 + i});
    SCOPED_TRACE(n);
    expect_plain_normals(mesh);
  }
}

TEST(NormalField, SeveralFansAtOneVertex) {
  // Two closed rings and two open ones, one of a single triangle.
  FaceMesh mesh = mesh_of(ring(16), {});
  for (std::uint32_t i = 0; i < 5; ++i) mesh.triangles.push_back({0, 2 + i, 2 + (i + 1) % 5});
  for (std::uint32_t i = 0; i < 3; ++i) mesh.triangles.push_back({0, 7 + i, 8 + i});
  for (std::uint32_t i = 0; i < 4; ++i) mesh.triangles.push_back({0, 12 + i, 12 + (i + 1) % 4});
  mesh.triangles.push_back({0, 16, 17});
  expect_plain_normals(mesh);
}

TEST(NormalField, TrianglesInAnyDisorder) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 200; ++run) {
    const int count = seeded.integer(3, 21);
    FaceMesh mesh;
    for (int i = 0; i < count; ++i) {
      mesh.positions.emplace_back(seeded.real(-1, 1), seeded.real(-1, 1), seeded.real(-1, 1));
    }
    // Also one triangle twice, both ways round, and with a corner twice.
    for (int i = seeded.integer(0, 60); i > 0; --i) {
      const auto corner = [&] { return static_cast<std::uint32_t>(seeded.integer(0, count - 1)); };
      mesh.triangles.push_back({corner(), corner(), corner()});
    }
    expect_plain_normals(mesh);
  }
}

TEST(NormalField, CreasesHaveNone) {
  // Two ribbons alike, the second a crease that begins within a block.
  FaceMesh mesh;
  for (int i = 0; i < 40; ++i) {
    mesh.positions.emplace_back(i / 2, i % 2, 0.1F * static_cast<float>(i % 5));
  }
  for (std::uint32_t i = 0; i + 2 < 40; ++i) {
    if (i < 18 || i >= 20) mesh.triangles.push_back({i, i + 1 + i % 2, i + 2 - i % 2});
  }
  mesh.parts = {{"skin", Material::Skin, 0, 20, 0, 18}, {"line", Material::Crease, 20, 20, 18, 18}};
  NormalField field(mesh);
  BlockSet moved(5);
  for (std::size_t block = 0; block < 5; ++block) moved.insert(block);
  std::vector<glm::vec3> normals(40, glm::vec3(7));
  field.update(moved, normals);
  const auto expected = plain_sums(mesh);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_LT(glm::distance(glm::dvec3(normals[i]), glm::normalize(expected[i])), 1e-5) << i;
  }
  for (std::size_t i = 20; i < 40; ++i) {
    EXPECT_EQ(normals[i], i < 24 ? glm::vec3(0, 0, 1) : glm::vec3(7)) << i;
  }
}

TEST(NormalField, WritesOnlyWhatAMovedVertexMayChange) {
  // A strip of triangles: the vertices of a block are near those of the next one.
  FaceMesh mesh;
  for (int i = 0; i < 60; ++i) {
    mesh.positions.emplace_back(i / 2, i % 2, 0.1F * static_cast<float>(i % 5));
  }
  for (std::uint32_t i = 0; i + 2 < 60; ++i) mesh.triangles.push_back({i, i + 1, i + 2});
  NormalField field(mesh);
  BlockSet moved(block_count(60));
  moved.insert(3);
  std::vector<glm::vec3> normals(60, glm::vec3(7));
  field.update(moved, normals);
  for (std::size_t i = 0; i < 60; ++i) {
    EXPECT_EQ(normals[i] != glm::vec3(7), i >= 16 && i < 40) << i;
  }
  moved.clear();
  EXPECT_TRUE(moved.empty());
  normals.assign(60, glm::vec3(7));
  field.update(moved, normals);
  EXPECT_EQ(normals, std::vector<glm::vec3>(60, glm::vec3(7)));
}

}  // namespace
}  // namespace aucast::face
