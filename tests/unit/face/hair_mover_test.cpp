#include "client/face/hair_mover.h"

#include <gtest/gtest.h>

#include <limits>

#include <glm/geometric.hpp>

#include "client/face/face_deformer.h"

namespace aucast::face {
namespace {

constexpr std::uint32_t kStrand = 8;  // vertices of a strand, from the crown to its end
constexpr float kTop = 8;
constexpr float kBottom = -6;

/// A cap of skin without use, and four strands: left, right, before and behind the head.
Face strands_face() {
  Face face;
  face.head = HeadPose{};
  face.hair = Hair{{0, 4, 0}, 6};
  FaceMesh& mesh = face.mesh;
  mesh.parts = {{"skin", Material::Skin, 0, kStrand, 0, 0},
                {"hair", Material::Hair, kStrand, 4 * kStrand, 0, 0}};
  for (const glm::vec3 side :
       {glm::vec3{0}, {5.0F, 0, 0}, {-5.0F, 0, 0}, {0, 0, 5.0F}, {0, 0, -5.0F}}) {
    for (std::uint32_t i = 0; i < kStrand; ++i) {
      const float along = static_cast<float>(i) / (kStrand - 1);
      mesh.positions.push_back({side.x, kTop + along * (kBottom - kTop), side.z});
    }
  }
  return face;
}

enum class Strand : std::uint8_t { Skin, Left, Right, Front, Back };

class HairMoverTest : public ::testing::Test {
 protected:
  /// Where the vertex `i` of a strand goes, from where it rests.
  glm::vec3 moved(const HairSway& sway, Strand strand, std::size_t i = kStrand - 1) {
    std::vector<VertexBlock> blocks = blocks_of(face_.mesh.positions);
    taken_ = BlockSet(blocks.size());
    mover_.take(sway, taken_);
    BlockSet all(blocks.size());
    for (std::size_t block = 0; block < blocks.size(); ++block) all.insert(block);
    mover_.apply(all, blocks);
    const auto block = static_cast<std::size_t>(strand);
    const glm::vec3 now(blocks[block].x[i], blocks[block].y[i], blocks[block].z[i]);
    return now - face_.mesh.positions[block * kLanes + i];
  }

  Face face_ = strands_face();
  HairMover mover_{face_};
  BlockSet taken_;
};

TEST_F(HairMoverTest, EndsGoWithTheSwayAndTheCrownStays) {
  EXPECT_GT(moved({1, 0, 0}, Strand::Front).x, 0.4F);   // towards the left
  EXPECT_GT(moved({0, 1, 0}, Strand::Front).z, 0.4F);   // forward, below the hinge
  EXPECT_LT(moved({0, 0, 1}, Strand::Right).x, -0.4F);  // outwards, below the hinge
  for (std::size_t i = 0; i < kStrand; ++i) {
    const glm::vec3 way = moved({1, 1, 1}, Strand::Left, i);
    const bool above = face_.mesh.positions[i].y >= face_.hair->hinge.y;
    EXPECT_EQ(above, way == glm::vec3(0)) << i;
  }
}

TEST_F(HairMoverTest, TheDeeperTheFurther) {
  float before = 0;
  for (std::size_t i = 3; i < kStrand; ++i) {
    const float way = glm::length(moved({1, 0, 0}, Strand::Front, i));
    EXPECT_GT(way, before);
    before = way;
  }
}

TEST_F(HairMoverTest, TowardsTheHeadItSwingsLess) {
  const auto way = [&](const HairSway& sway, Strand strand) {
    return glm::length(moved(sway, strand));
  };
  EXPECT_LT(way({0, 0, 1}, Strand::Left), way({0, 0, -1}, Strand::Left) / 2);
  EXPECT_LT(way({0, 0, -1}, Strand::Right), way({0, 0, 1}, Strand::Right) / 2);
  EXPECT_LT(way({0, 1, 0}, Strand::Back), way({0, -1, 0}, Strand::Back) / 2);
  EXPECT_LT(way({0, -1, 0}, Strand::Front), way({0, 1, 0}, Strand::Front) / 2);
}

TEST_F(HairMoverTest, SwingsNoFurtherThanTheFaceSaysAndNotByWhatIsNoNumber) {
  const glm::vec3 most = moved({1, 1, 1}, Strand::Front);
  EXPECT_EQ(moved({7, 2, 100}, Strand::Front), most);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(moved({nan, nan, nan}, Strand::Front), glm::vec3(0));
}

TEST_F(HairMoverTest, OnlyAnotherSwayMovesOnlyHair) {
  moved({}, Strand::Left);
  EXPECT_TRUE(taken_.empty());
  moved({0.5F, 0, 0}, Strand::Left);
  EXPECT_TRUE(taken_.contains(static_cast<std::size_t>(Strand::Left)));
  EXPECT_FALSE(taken_.contains(static_cast<std::size_t>(Strand::Skin)));
  moved({0.5F, 0, 0}, Strand::Left);
  EXPECT_TRUE(taken_.empty());
}

TEST_F(HairMoverTest, AFaceComesBackToItsPlaceToTheLastBit) {
  FaceDeformer deformer(face_);
  const std::vector<glm::vec3> rest = deformer.deform({}).positions;
  EXPECT_EQ(rest, face_.mesh.positions);
  EXPECT_NE(deformer.deform({}, {-1, 0.5F, 0}).positions, rest);
  EXPECT_EQ(deformer.deform({}).positions, rest);
}

TEST_F(HairMoverTest, FacesWithoutHairThatSwingsIgnoreIt) {
  face_.hair.reset();
  FaceDeformer deformer(face_);
  EXPECT_EQ(deformer.deform({}, {-1, 0.5F, 0}).positions, face_.mesh.positions);
}

}  // namespace
}  // namespace aucast::face
