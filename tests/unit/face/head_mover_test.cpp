#include "client/face/head_mover.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "tests/support/seeded.h"

namespace aucast::face {
namespace {

using aucast::test::Seeded;

// Three blocks of vertices: one that does not go with the head, one that goes wholly, and the neck
// between them, whose last lane goes wholly, too.
constexpr std::size_t kStill = 0;
constexpr std::size_t kWhole = 1;
constexpr std::size_t kNeck = 2;

constexpr HeadPose kHead{{0.0F, -4.5F, -0.5F}, 35, 22, 20, 1.5F};

Face headed_face(Seeded& seeded) {
  Face face;
  face.head = kHead;
  std::vector<float> weights;
  for (std::size_t i = 0; i < 3 * kLanes; ++i) {
    glm::vec3 point(0);
    for (int axis = 0; axis < 3; ++axis) point[axis] = static_cast<float>(seeded.real(-9, 9));
    face.mesh.positions.push_back(point);
    const auto share = static_cast<float>(i % kLanes) / static_cast<float>(kLanes - 1);
    weights.push_back(i / kLanes == kStill ? 0 : i / kLanes == kWhole ? 1 : share);
  }
  face.mesh.maps["head"] = weights;
  return face;
}

HeadMover::Pose random_pose(Seeded& seeded) {
  const auto share = [&seeded] { return static_cast<float>(seeded.real(-1, 1)); };
  return {share(), share(), share(), share()};
}

glm::vec3 vertex_of(const VertexBlock& block, std::size_t lane) {
  return {block.x[lane], block.y[lane], block.z[lane]};
}

class HeadMoverTest : public ::testing::Test {
 protected:
  /// Where the head carries a block of the mesh.
  VertexBlock placed(std::size_t block) {
    VertexBlock to;
    turn_.apply(block, block_at(face_.mesh.positions, block), to);
    return to;
  }
  /// Takes a pose, and gives the blocks that it moves.
  BlockSet take(const HeadMover::Pose& pose) {
    BlockSet moved(3);
    turn_.take(pose, moved);
    return moved;
  }
  /// Where a point goes that takes a share in a pose.
  glm::vec3 carried(const HeadMover::Pose& pose, float share, glm::vec3 point) {
    take(pose);
    glm::vec3 direction(0, 0, 1);
    turn_.carry(share, point, direction);
    return point;
  }

  Seeded seeded_;
  Face face_ = headed_face(seeded_);
  HeadMover turn_{face_};
};

TEST_F(HeadMoverTest, OnlyAnotherPoseMovesAnything) {
  EXPECT_FALSE(turn_.turned());
  EXPECT_TRUE(take({}).empty());
  const BlockSet moved = take({0.5F, 0, 0, 0});
  EXPECT_TRUE(turn_.turned());
  EXPECT_FALSE(moved.contains(kStill));
  EXPECT_TRUE(moved.contains(kWhole));
  EXPECT_TRUE(moved.contains(kNeck));
  EXPECT_TRUE(take({0.5F, 0, 0, 0}).empty());
  EXPECT_FALSE(take({}).empty());
  EXPECT_FALSE(turn_.turned());
}

TEST_F(HeadMoverTest, WhatDoesNotGoWithItStaysBitForBit) {
  SCOPED_TRACE(seeded_.trace());
  take({1, -1, 1, -1});
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    EXPECT_EQ(vertex_of(placed(kStill), lane), face_.mesh.positions[lane]) << lane;
  }
  EXPECT_EQ(vertex_of(placed(kNeck), 0), face_.mesh.positions[kNeck * kLanes]);
}

TEST_F(HeadMoverTest, WhatGoesWhollyIsOneRigidBodyAndTurnsAsTheNeckDoesWhereThatGoesWholly) {
  SCOPED_TRACE(seeded_.trace());
  for (int run = 0; run < 50; ++run) {
    const HeadMover::Pose pose = random_pose(seeded_);
    take(pose);
    const VertexBlock whole = placed(kWhole);
    const auto* const rest = &face_.mesh.positions[kWhole * kLanes];
    for (std::size_t lane = 1; lane < kLanes; ++lane) {
      EXPECT_NEAR(glm::distance(vertex_of(whole, lane), vertex_of(whole, 0)),
                  glm::distance(rest[lane], rest[0]), 1e-5F);
      EXPECT_LT(glm::distance(vertex_of(whole, lane), carried(pose, 1, rest[lane])), 1e-5F);
    }
    EXPECT_LT(glm::distance(vertex_of(placed(kNeck), kLanes - 1),
                            carried(pose, 1, face_.mesh.positions.back())),
              1e-5F);
  }
}

TEST_F(HeadMoverTest, TheNeckTakesItsShareOfTheTurn) {
  SCOPED_TRACE(seeded_.trace());
  const HeadMover::Pose pose = random_pose(seeded_);
  take(pose);
  const VertexBlock neck = placed(kNeck);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const std::size_t vertex = kNeck * kLanes + lane;
    EXPECT_LT(glm::distance(vertex_of(neck, lane), carried(pose, face_.mesh.maps["head"][vertex],
                                                           face_.mesh.positions[vertex])),
              1e-5F)
        << lane;
  }
}

TEST_F(HeadMoverTest, GoesWhereTheNamesOfItsChannelsSay) {
  const glm::vec3 nose = kHead.pivot + glm::vec3(0, 0, 10);
  const glm::vec3 crown = kHead.pivot + glm::vec3(0, 10, 0);
  const auto lies_at = [](const glm::vec3& point, const glm::vec3& from_pivot) {
    return glm::distance(point, kHead.pivot + from_pivot) < 1e-5F;
  };
  const float turn = 35 * kRadPerDeg;
  const float pitch = 22 * kRadPerDeg;
  const float tilt = 20 * kRadPerDeg;
  EXPECT_TRUE(
      lies_at(carried({1, 0, 0, 0}, 1, nose), {10 * std::sin(turn), 0, 10 * std::cos(turn)}));
  EXPECT_TRUE(
      lies_at(carried({0, 1, 0, 0}, 1, nose), {0, 10 * std::sin(pitch), 10 * std::cos(pitch)}));
  EXPECT_TRUE(
      lies_at(carried({0, 0, 1, 0}, 1, crown), {10 * std::sin(tilt), 10 * std::cos(tilt), 0}));
  EXPECT_TRUE(lies_at(carried({0, 0, 0, 1}, 1, nose), {0, 0, 11.5F}));
  EXPECT_TRUE(lies_at(carried({0, 0, 0, -0.5F}, 0.5F, nose), {0, 0, 10 - 0.375F}));
}

TEST_F(HeadMoverTest, LeftAndRightAreMirrorImages) {
  SCOPED_TRACE(seeded_.trace());
  const auto mirrored_point = [](glm::vec3 point) {
    point.x = -point.x;
    return point;
  };
  for (int run = 0; run < 50; ++run) {
    const HeadMover::Pose pose = random_pose(seeded_);
    const HeadMover::Pose other{-pose.turn, pose.pitch, -pose.tilt, pose.shift};
    const glm::vec3 point = face_.mesh.positions[static_cast<std::size_t>(run) % 24];
    const auto share = static_cast<float>(seeded_.real(0, 1));
    EXPECT_LT(glm::distance(carried(pose, share, point),
                            mirrored_point(carried(other, share, mirrored_point(point)))),
              1e-5F);
  }
}

TEST_F(HeadMoverTest, ADirectionIsTurnedAndNotMoved) {
  take({1, 0, 0, 1});
  glm::vec3 point(1, 2, 3);
  glm::vec3 direction(0, 1, 0);
  turn_.carry(1, point, direction);
  EXPECT_LT(glm::distance(direction, {0, 1, 0}), 1e-6F) << "the axis that it turns about";
  direction = {0, 0, 1};
  turn_.carry(1, point, direction);
  EXPECT_NEAR(glm::length(direction), 1, 1e-5F);
  EXPECT_NEAR(direction.x, std::sin(35 * kRadPerDeg), 1e-5F);
  const glm::vec3 before = point;
  turn_.carry(0, point, direction);
  EXPECT_EQ(point, before) << "without a share";
}

}  // namespace
}  // namespace aucast::face
