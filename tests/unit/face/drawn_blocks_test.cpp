#include "client/face/drawn_blocks.h"

#include <gtest/gtest.h>

#include "client/face/vertex_block.h"
#include "tests/support/seeded.h"

namespace aucast::face {
namespace {

using aucast::test::Seeded;

// Five blocks: two of skin, whose second is shared with the first crease; that crease's other
// block, which is shared with the second crease; the rest of that one; and a crease that no channel
// drives.
constexpr std::size_t kBlocks = 5;
constexpr std::size_t kSharedWithSkin = 1;
constexpr std::size_t kSharedByCreases = 2;
constexpr std::size_t kSecondAlone = 3;
constexpr std::size_t kUndriven = 4;

Face creased_face() {
  Face face;
  face.mesh.positions.resize(kBlocks * kLanes);
  face.mesh.parts = {{"skin", Material::Skin, 0, 12, 0, 0},
                     {"brow_lines", Material::Crease, 12, 8, 0, 0},
                     {"nose_lines", Material::Crease, 20, 12, 0, 0},
                     {"lost_lines", Material::Crease, 32, 8, 0, 0}};
  face.channels = {
      {"jaw", Side::Both, 4}, {"nose_lines", Side::Both, 1}, {"brow_lines", Side::Both, 1}};
  return face;
}

/// The activations of jaw, nose and brow lines.
std::vector<float> depths_of(float brow, float nose) {
  return {1.0F, nose, brow};
}

std::vector<std::size_t> members(const BlockSet& set) {
  std::vector<std::size_t> blocks;
  set.for_each([&](std::size_t block) { blocks.push_back(block); });
  return blocks;
}

std::vector<std::size_t> narrowed(const DrawnBlocks& drawn, std::initializer_list<std::size_t> of) {
  BlockSet set(kBlocks);
  for (const std::size_t block : of) set.insert(block);
  drawn.narrow(set);
  return members(set);
}

using Blocks = std::vector<std::size_t>;

TEST(DrawnBlocks, KnowsWhichVerticesBelongToCreases) {
  const std::vector<bool> crease = crease_vertices(creased_face().mesh);
  for (std::size_t i = 0; i < crease.size(); ++i) EXPECT_EQ(crease[i], i >= 12) << i;
  EXPECT_EQ(members(always_drawn(creased_face().mesh)), (Blocks{0, kSharedWithSkin}));
}

TEST(DrawnBlocks, WithoutAnExpressionOnlySkinMoves) {
  const Face face = creased_face();
  DrawnBlocks drawn(face);
  drawn.take(depths_of(0, 0));
  EXPECT_EQ(drawn.depths(), (std::vector<float>{0, 0, 0}));
  EXPECT_EQ(narrowed(drawn, {0, 1, 2, 3, 4}), (Blocks{0, kSharedWithSkin}));
  EXPECT_EQ(narrowed(drawn, {3}), Blocks{});
  EXPECT_TRUE(drawn.vanished().empty());
}

TEST(DrawnBlocks, WhatAppearsIsMovedWhateverElseMoves) {
  const Face face = creased_face();
  DrawnBlocks drawn(face);
  drawn.take(depths_of(0, 0.5F));
  EXPECT_EQ(drawn.depths(), (std::vector<float>{0, 0.5F, 0})) << "in the order of the parts";
  EXPECT_EQ(narrowed(drawn, {0}), (Blocks{0, kSharedByCreases, kSecondAlone}));
  drawn.take(depths_of(0, 0.7F));
  EXPECT_EQ(narrowed(drawn, {0}), Blocks{0}) << "it was drawn before";
  EXPECT_EQ(narrowed(drawn, {0, 3, 4}), (Blocks{0, kSecondAlone}));
}

TEST(DrawnBlocks, WhatVanishesIsToldOnceAndNotWhatAnotherStillDraws) {
  const Face face = creased_face();
  DrawnBlocks drawn(face);
  drawn.take(depths_of(0.2F, 0.2F));
  EXPECT_TRUE(drawn.vanished().empty());
  drawn.take(depths_of(0.2F, 0));
  EXPECT_EQ(members(drawn.vanished()), Blocks{kSecondAlone});
  drawn.take(depths_of(0.2F, 0));
  EXPECT_TRUE(drawn.vanished().empty());
  drawn.take(depths_of(0, 0));
  EXPECT_EQ(members(drawn.vanished()), Blocks{kSharedByCreases}) << "the skin keeps its block";
}

TEST(DrawnBlocks, ACreaseWithoutAChannelIsNeverDrawn) {
  const Face face = creased_face();
  DrawnBlocks drawn(face);
  drawn.take({std::vector<float>(3, 1.0F)});
  EXPECT_EQ(drawn.depths().back(), 0.0F);
  EXPECT_EQ(narrowed(drawn, {kUndriven}), (Blocks{kSharedWithSkin + 1, kSecondAlone}));
}

TEST(DrawnBlocks, WhatTheSkinKeepsIsDrawnAtRestAndAnExpressionDeepensIt) {
  Face face = creased_face();
  face.channels[1].kept = 0.25F;
  EXPECT_EQ(kept_depths(face), (std::vector<float>{0, 0.25F, 0}));
  DrawnBlocks drawn(face);
  EXPECT_EQ(drawn.depths(), (std::vector<float>{0, 0.25F, 0}));
  drawn.take(depths_of(0, 0));
  EXPECT_EQ(narrowed(drawn, {0, 2, 3}), (Blocks{0, kSharedByCreases, kSecondAlone}));
  drawn.take(depths_of(0, 0.5F));
  EXPECT_EQ(drawn.depths()[1], 0.625F);
  drawn.take(depths_of(0, 1));
  EXPECT_EQ(drawn.depths()[1], 1.0F);
  drawn.take(depths_of(0, 0));
  EXPECT_TRUE(drawn.vanished().empty());
}

/// The same, said as plainly as it can be.
struct PlainDrawn {
  std::vector<bool> drawn;

  static PlainDrawn with(float brow, float nose) {
    return {{true, true, brow > 0 || nose > 0, nose > 0, false}};
  }
};

TEST(DrawnBlocks, IsWhatTheCreasesOfBothMomentsSay) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const Face face = creased_face();
  DrawnBlocks drawn(face);
  PlainDrawn before = PlainDrawn::with(0, 0);
  for (int run = 0; run < 500; ++run) {
    const float brow = seeded.chance(0.5) ? 0.0F : static_cast<float>(seeded.real(0.01, 1));
    const float nose = seeded.chance(0.5) ? 0.0F : static_cast<float>(seeded.real(0.01, 1));
    drawn.take(depths_of(brow, nose));
    const PlainDrawn now = PlainDrawn::with(brow, nose);
    BlockSet moved(kBlocks);
    for (std::size_t block = 0; block < kBlocks; ++block) {
      if (seeded.chance(0.5)) moved.insert(block);
    }
    BlockSet left = moved;
    drawn.narrow(left);
    for (std::size_t block = 0; block < kBlocks; ++block) {
      const bool appeared = now.drawn[block] && !before.drawn[block];
      EXPECT_EQ(left.contains(block), (moved.contains(block) && now.drawn[block]) || appeared);
      EXPECT_EQ(drawn.vanished().contains(block), before.drawn[block] && !now.drawn[block]);
    }
    before = now;
  }
}

}  // namespace
}  // namespace aucast::face
