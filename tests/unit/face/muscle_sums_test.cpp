#include "client/face/muscle_sums.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/support/displacement.h"
#include "tests/support/seeded.h"
#include "tests/unit/face/small_face.h"

namespace aucast::face {
namespace {

using aucast::test::displacement;
using aucast::test::Seeded;

constexpr float kSumTolerance = 2e-6F;

/// About a third of the muscles, so that another few act each time.
std::vector<float> some(Seeded& seeded, std::size_t muscles) {
  std::vector<float> activations(muscles, 0.0F);
  for (float& activation : activations) {
    if (seeded.chance(0.3)) activation = static_cast<float>(seeded.real(0, 2));
  }
  return activations;
}

BlockSet every_block(const Face& face) {
  const std::size_t count = block_count(face.mesh.positions.size());
  BlockSet all(count);
  for (std::size_t block = 0; block < count; ++block) all.insert(block);
  return all;
}

TEST(MuscleSums, AddEachMusclesDisplacement) {
  const Face face = test::small_face();
  const BlockSet all = every_block(face);
  BlockSet moved(block_count(face.mesh.positions.size()));
  for (std::size_t m = 0; m < face.muscles.size(); ++m) {
    const Muscle& muscle = face.muscles[m];
    MuscleSums sums(face);
    std::vector<float> activations(face.muscles.size(), 0.0F);
    activations[m] = 0.75F;
    sums.take(activations, moved);
    sums.list(all);
    const auto* const reach = muscle.mask_alone ? nullptr : find_map(face.mesh, "muscle");
    const auto* const mask = muscle.mask.empty() ? nullptr : find_map(face.mesh, muscle.mask);
    for (std::size_t i = 0; i < face.mesh.positions.size(); ++i) {
      VertexBlock place;
      sums.at(i / kLanes, place);
      const std::size_t lane = i % kLanes;
      const glm::vec3& rest = face.mesh.positions[i];
      const glm::vec3 expected = rest + map_at(reach, i, 1) * map_at(mask, i, 1) *
                                            displacement(muscle.shape, rest, activations[m]);
      ASSERT_LT(glm::distance({place.x[lane], place.y[lane], place.z[lane]}, expected),
                kSumTolerance)
          << muscle.name << ", vertex " << i;
    }
  }
}

TEST(MuscleSums, MoveAVertexAsThePlaceOfItsRoot) {
  Face face = test::small_face();
  constexpr float kBelow = 0.4F;
  face.mesh.maps["root_below"].assign(face.mesh.positions.size(), 0.0F);
  for (std::size_t i = 0; i < face.mesh.positions.size(); i += 2) {
    face.mesh.maps["root_below"][i] = kBelow;
  }
  BlockSet moved(block_count(face.mesh.positions.size()));
  for (std::size_t m = 0; m < face.muscles.size(); ++m) {
    const Muscle& muscle = face.muscles[m];
    MuscleSums sums(face);
    std::vector<float> activations(face.muscles.size(), 0.0F);
    activations[m] = 0.75F;
    sums.take(activations, moved);
    sums.list(every_block(face));
    const auto* const reach = muscle.mask_alone ? nullptr : find_map(face.mesh, "muscle");
    const auto* const mask = muscle.mask.empty() ? nullptr : find_map(face.mesh, muscle.mask);
    for (std::size_t i = 0; i < face.mesh.positions.size(); ++i) {
      VertexBlock place;
      sums.at(i / kLanes, place);
      const std::size_t lane = i % kLanes;
      const glm::vec3& rest = face.mesh.positions[i];
      const glm::vec3 root = rest - glm::vec3(0, i % 2 == 0 ? kBelow : 0.0F, 0);
      const glm::vec3 expected = rest + map_at(reach, i, 1) * map_at(mask, i, 1) *
                                            displacement(muscle.shape, root, activations[m]);
      ASSERT_LT(glm::distance({place.x[lane], place.y[lane], place.z[lane]}, expected),
                kSumTolerance)
          << muscle.name << ", vertex " << i;
    }
  }
}

TEST(MuscleSums, ForgetWhatActedBefore) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const Face face = test::small_face();
  BlockSet moved(block_count(face.mesh.positions.size()));
  const BlockSet all = every_block(face);
  MuscleSums used(face);
  for (int run = 0; run < 20; ++run) {
    const std::vector<float> activations = run % 5 == 4
                                               ? std::vector<float>(face.muscles.size(), 0.0F)
                                               : some(seeded, face.muscles.size());
    MuscleSums fresh(face);
    used.take(activations, moved);
    used.list(all);
    fresh.take(activations, moved);
    fresh.list(all);
    for (std::size_t block = 0; block < used.rest().size(); ++block) {
      VertexBlock a;
      VertexBlock b;
      used.at(block, a);
      fresh.at(block, b);
      ASSERT_EQ(a.x, b.x) << "block " << block;
      ASSERT_EQ(a.y, b.y) << "block " << block;
      ASSERT_EQ(a.z, b.z) << "block " << block;
    }
  }
}

TEST(MuscleSums, AreTheSameWhicheverBlocksAreListed) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const Face face = test::small_face();
  BlockSet moved(block_count(face.mesh.positions.size()));
  MuscleSums whole(face);
  MuscleSums partly(face);
  std::vector<float> activations;
  for (int run = 0; run < 30; ++run) {
    // The same muscles act in the next two: what is listed only changes with what is asked for.
    if (run % 3 == 0) activations = some(seeded, face.muscles.size());
    whole.take(activations, moved);
    whole.list(every_block(face));
    BlockSet asked(whole.rest().size());
    for (std::size_t block = 0; block < whole.rest().size(); ++block) {
      if (seeded.chance(0.2)) asked.insert(block);
    }
    partly.take(activations, moved);
    partly.list(asked);
    asked.for_each([&](std::size_t block) {
      VertexBlock a;
      VertexBlock b;
      whole.at(block, a);
      partly.at(block, b);
      ASSERT_EQ(a.x, b.x) << "block " << block;
      ASSERT_EQ(a.y, b.y) << "block " << block;
      ASSERT_EQ(a.z, b.z) << "block " << block;
    });
  }
}

TEST(MuscleSums, TellWhichBlocksAMuscleMovesAndNoOthers) {
  const Face face = test::small_face();
  for (std::size_t m = 0; m < face.muscles.size(); ++m) {
    MuscleSums sums(face);
    std::vector<float> activations(face.muscles.size(), 0.0F);
    activations[m] = 0.5F;
    BlockSet moved(sums.rest().size());
    sums.take(activations, moved);
    sums.list(every_block(face));
    for (std::size_t block = 0; block < sums.rest().size(); ++block) {
      VertexBlock place;
      sums.at(block, place);
      const VertexBlock& rest = sums.rest()[block];
      const bool elsewhere = place.x != rest.x || place.y != rest.y || place.z != rest.z;
      EXPECT_TRUE(moved.contains(block) || !elsewhere) << face.muscles[m].name;
    }
    EXPECT_FALSE(moved.empty()) << face.muscles[m].name;
    moved.clear();
    sums.take(activations, moved);
    EXPECT_TRUE(moved.empty()) << "nothing has changed";
  }
}

TEST(MuscleSums, WhatGoesBeyondTheCapIsNoChange) {
  const Face face = test::small_face();
  const std::size_t zygomatic = *face.channel_index("left_zygomaticus_major");
  ASSERT_TRUE(std::get<LinearMuscle>(face.muscles[zygomatic].shape).cap.has_value());
  MuscleSums sums(face);
  BlockSet moved(sums.rest().size());
  std::vector<float> activations(face.muscles.size(), 0.0F);
  activations[zygomatic] = 50;
  sums.take(activations, moved);
  EXPECT_FALSE(moved.empty());
  moved.clear();
  activations[zygomatic] = 60;
  sums.take(activations, moved);
  EXPECT_TRUE(moved.empty());
}

}  // namespace
}  // namespace aucast::face
