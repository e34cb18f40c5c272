#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "common/files.h"
#include "scripts/facegen/head.h"

namespace aucast {
namespace {

// The committed heads are what scripts/facegen writes; numbers may differ in the last digits
// between compilers, indices may not. AUCAST_SHIPPED_FACE names one that is not the default.

constexpr float kTolerance = 1e-4F;

class CommittedHead : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    const auto data = find_data_folder({});
    ASSERT_TRUE(data) << data.error().message;
    const char* const shipped = std::getenv("AUCAST_SHIPPED_FACE");
    const std::string name = shipped == nullptr ? "default" : shipped;
    const auto who = facegen::identity_named(name);
    ASSERT_TRUE(who) << who.error().message;
    const auto bytes = read_file(*data / "faces" / name / "mesh.ply");
    ASSERT_TRUE(bytes) << bytes.error().message;
    committed_bytes_ = bytes->size();
    auto committed = face::parse_ply(*bytes, "mesh.ply");
    ASSERT_TRUE(committed) << committed.error().message;
    committed_ = std::move(committed).value();
    const auto head = facegen::make_head(*who);
    ASSERT_TRUE(head) << head.error().message;
    auto made = face::parse_ply(facegen::head_file(*head), "made");
    ASSERT_TRUE(made) << made.error().message;
    made_ = std::move(made).value();
  }
  static void TearDownTestSuite() {
    committed_ = {};
    made_ = {};
  }

  static face::FaceMesh committed_;
  static face::FaceMesh made_;
  static std::size_t committed_bytes_;
};

face::FaceMesh CommittedHead::committed_;
face::FaceMesh CommittedHead::made_;
std::size_t CommittedHead::committed_bytes_ = 0;

constexpr const char* kRemedy =
    "; if the generator was changed on purpose: build/release/bin/facegen data/faces/NAME NAME";

void expect_same(const std::vector<float>& a, const std::vector<float>& b,
                 const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  float largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  EXPECT_LE(largest, kTolerance) << what << kRemedy;
}

TEST_F(CommittedHead, HasTheSamePartsAsTheGenerated) {
  ASSERT_EQ(committed_.parts.size(), made_.parts.size()) << kRemedy;
  for (std::size_t i = 0; i < made_.parts.size(); ++i) {
    SCOPED_TRACE(made_.parts[i].name);
    EXPECT_EQ(committed_.parts[i].name, made_.parts[i].name);
    EXPECT_EQ(committed_.parts[i].material, made_.parts[i].material);
    EXPECT_EQ(committed_.parts[i].vertex_begin, made_.parts[i].vertex_begin);
    EXPECT_EQ(committed_.parts[i].vertex_count, made_.parts[i].vertex_count);
    EXPECT_EQ(committed_.parts[i].triangle_begin, made_.parts[i].triangle_begin);
    EXPECT_EQ(committed_.parts[i].triangle_count, made_.parts[i].triangle_count);
  }
}

TEST_F(CommittedHead, HasExactlyTheSameTriangles) {
  EXPECT_TRUE(committed_.triangles == made_.triangles) << kRemedy;
}

TEST_F(CommittedHead, HasTheSamePositions) {
  ASSERT_EQ(committed_.positions.size(), made_.positions.size());
  float largest = 0;
  for (std::size_t i = 0; i < made_.positions.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      largest =
          std::max(largest, std::abs(committed_.positions[i][axis] - made_.positions[i][axis]));
    }
  }
  EXPECT_LE(largest, kTolerance) << kRemedy;
}

TEST_F(CommittedHead, HasTheSameMaps) {
  expect_same(committed_.occlusion, made_.occlusion, "occlusion");
  expect_same(committed_.gloss, made_.gloss, "gloss");
  ASSERT_EQ(committed_.maps.size(), made_.maps.size());
  for (const auto& [name, values] : made_.maps) {
    ASSERT_TRUE(committed_.maps.contains(name)) << name;
    expect_same(committed_.maps.at(name), values, name);
  }
}

TEST_F(CommittedHead, HasTheSameColoursToOneStep) {
  ASSERT_EQ(committed_.colours.size(), made_.colours.size());
  // The steepest of the 256 sRGB steps, at white.
  constexpr float kStep = 0.0095F;
  float largest = 0;
  for (std::size_t i = 0; i < made_.colours.size(); ++i) {
    for (int c = 0; c < 4; ++c) {
      largest = std::max(largest, std::abs(committed_.colours[i][c] - made_.colours[i][c]));
    }
  }
  EXPECT_LE(largest, kStep) << kRemedy;
}

TEST_F(CommittedHead, HasTheLoopsOfTheDefaultFace) {
  const auto data = find_data_folder({});
  ASSERT_TRUE(data) << data.error().message;
  const auto bytes = read_file(*data / "faces/default/mesh.ply");
  ASSERT_TRUE(bytes) << bytes.error().message;
  const auto standard = face::parse_ply(*bytes, "mesh.ply");
  ASSERT_TRUE(standard) << standard.error().message;
  EXPECT_EQ(committed_.positions.size(), standard->positions.size());
  EXPECT_TRUE(committed_.triangles == standard->triangles);
}

TEST_F(CommittedHead, StaysSmall) {
  EXPECT_LT(committed_bytes_, 3'200'000U);
}

}  // namespace
}  // namespace aucast
