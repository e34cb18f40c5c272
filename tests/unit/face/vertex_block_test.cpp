#include "client/face/vertex_block.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "client/face/block_turns.h"
#include "tests/support/seeded.h"

namespace aucast::face {
namespace {

using aucast::test::Seeded;

constexpr float kQuarterTurn = std::numbers::pi_v<float> / 2;

std::vector<glm::vec3> random_points(Seeded& seeded, std::size_t count) {
  std::vector<glm::vec3> points(count);
  for (glm::vec3& point : points) {
    for (int axis = 0; axis < 3; ++axis) point[axis] = static_cast<float>(seeded.real(-9, 9));
  }
  return points;
}

glm::vec3 lane_of(const VertexBlock& block, std::size_t lane) {
  return {block.x[lane], block.y[lane], block.z[lane]};
}

Lanes filled_lanes(float value) {
  Lanes lanes{};
  lanes.fill(value);
  return lanes;
}

TEST(VertexBlock, CountsTheLastBlockEvenIfItIsShort) {
  EXPECT_EQ(block_count(0), 0U);
  EXPECT_EQ(block_count(1), 1U);
  EXPECT_EQ(block_count(kLanes), 1U);
  EXPECT_EQ(block_count(kLanes + 1), 2U);
}

TEST(VertexBlock, PointsComeBackBitForBitHoweverManyThereAre) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (std::size_t count = 1; count <= 3 * kLanes; ++count) {
    const std::vector<glm::vec3> points = random_points(seeded, count);
    const std::vector<VertexBlock> blocks = blocks_of(points);
    ASSERT_EQ(blocks.size(), block_count(count));
    std::vector<glm::vec3> back(count + 1, glm::vec3(77));
    const std::span<glm::vec3> all = std::span(back).first(count);
    for (std::size_t block = 0; block < blocks.size(); ++block) {
      write_points(points_of(blocks[block]), block_of(all, block));
    }
    EXPECT_EQ(std::vector<glm::vec3>(all.begin(), all.end()), points) << count;
    EXPECT_EQ(back.back(), glm::vec3(77)) << "written beyond the end of " << count;
  }
}

TEST(VertexBlock, LanesBeyondTheMeshAndTheFourthOfAPointAreZero) {
  const std::vector<glm::vec3> points(kLanes + 3, glm::vec3(1, 2, 3));
  const std::vector<VertexBlock> blocks = blocks_of(points);
  for (std::size_t lane = 3; lane < kLanes; ++lane) {
    EXPECT_EQ(lane_of(blocks[1], lane), glm::vec3(0)) << lane;
  }
  for (const Four& point : points_of(blocks[0])) EXPECT_EQ(point[3], 0.0F);
}

TEST(VertexBlock, ACopyIsTheSameInEveryLane) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const VertexBlock from = block_at(random_points(seeded, kLanes), 0);
  VertexBlock to;
  copy_block(from, to);
  EXPECT_EQ(to.x, from.x);
  EXPECT_EQ(to.y, from.y);
  EXPECT_EQ(to.z, from.z);
}

// === block_turns.h

TEST(BlockTurns, SineAndCosineAreGoodToTheLastDigitsUpToAQuarterTurn) {
  for (int i = -1000; i <= 1000; ++i) {
    const float angle = kQuarterTurn * static_cast<float>(i) / 1000;
    const Four x = in_all_lanes(angle);
    EXPECT_NEAR(turn_sine(x)[0], std::sin(static_cast<double>(angle)), 2e-7) << angle;
    EXPECT_NEAR(turn_cosine_less_one(x)[3], std::cos(static_cast<double>(angle)) - 1, 2e-7)
        << angle;
  }
  EXPECT_EQ(turn_sine(Four{})[0], 0.0F);
  EXPECT_EQ(turn_cosine_less_one(Four{})[0], 0.0F);
}

TEST(BlockTurns, WhatHasNoShareStaysBitForBit) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const VertexBlock rest = block_at(random_points(seeded, kLanes), 0);
  Lanes weights = filled_lanes(0);
  weights[2] = 0.5F;
  VertexBlock turned = rest;
  pitch(turned, weights, 1, 0.1F, 0.2F);
  turn(turned, weights, 1, 0.3F, 0.4F);
  tilt(turned, weights, 1, 0.5F, 0.6F);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (lane == 2) {
      EXPECT_NE(lane_of(turned, lane), lane_of(rest, lane));
    } else {
      EXPECT_EQ(lane_of(turned, lane), lane_of(rest, lane)) << lane;
    }
  }
}

TEST(BlockTurns, PositiveAnglesGoWhereTheySay) {
  const Lanes wholly = filled_lanes(1);
  VertexBlock block;
  for (std::size_t lane = 0; lane < kLanes; ++lane) set_lane(block, lane, {1, 2, 8});
  pitch(block, wholly, kQuarterTurn, 2, 3);
  EXPECT_LT(glm::distance(lane_of(block, 5), {1, 7, 3}), 1e-6F) << "what is in front goes up";
  for (std::size_t lane = 0; lane < kLanes; ++lane) set_lane(block, lane, {1, 2, 8});
  turn(block, wholly, kQuarterTurn, 1, 3);
  EXPECT_LT(glm::distance(lane_of(block, 5), {6, 2, 3}), 1e-6F) << "what is in front goes to +x";
  for (std::size_t lane = 0; lane < kLanes; ++lane) set_lane(block, lane, {1, 7, 8});
  tilt(block, wholly, kQuarterTurn, 1, 2);
  EXPECT_LT(glm::distance(lane_of(block, 5), {6, 2, 8}), 1e-6F) << "what is above goes to +x";
}

TEST(BlockTurns, EachVertexTurnsByItsShareAndKeepsItsDistance) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 200; ++run) {
    const VertexBlock rest = block_at(random_points(seeded, kLanes), 0);
    Lanes weights{};
    for (float& weight : weights) weight = static_cast<float>(seeded.real(-1, 1));
    VertexBlock turned = rest;
    pitch(turned, weights, kQuarterTurn, 1, 2);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const double y = rest.y[lane] - 1.0;
      const double z = rest.z[lane] - 2.0;
      const double angle = static_cast<double>(kQuarterTurn) * static_cast<double>(weights[lane]);
      EXPECT_EQ(turned.x[lane], rest.x[lane]);
      EXPECT_NEAR(turned.y[lane], 1 + std::cos(angle) * y + std::sin(angle) * z, 1e-5);
      EXPECT_NEAR(turned.z[lane], 2 + std::cos(angle) * z - std::sin(angle) * y, 1e-5);
    }
  }
}

}  // namespace
}  // namespace aucast::face
