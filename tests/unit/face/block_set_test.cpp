#include "client/face/block_set.h"

#include <gtest/gtest.h>

#include "tests/support/seeded.h"

namespace aucast::face {
namespace {

TEST(BlockSet, HoldsWhatWasPutIn) {
  aucast::test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (const int count : {1, 63, 64, 65, 200}) {
    BlockSet set(static_cast<std::size_t>(count));
    BlockSet other = set;
    EXPECT_TRUE(set.empty());
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      if (!seeded.chance(0.4)) continue;
      expected.push_back(i);
      (seeded.chance(0.5) ? set : other).insert(i);
    }
    set |= other;
    std::vector<std::size_t> seen;
    set.for_each([&](std::size_t block) { seen.push_back(block); });
    EXPECT_EQ(seen, expected);
    EXPECT_EQ(set.empty(), expected.empty());
    for (const std::size_t block : expected) EXPECT_TRUE(set.contains(block));
  }
}

TEST(BlockSet, ComparesAndCutsLikeSets) {
  aucast::test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  constexpr std::size_t kCount = 150;
  BlockSet a(kCount);
  BlockSet b(kCount);
  for (std::size_t i = 0; i < kCount; ++i) {
    if (seeded.chance(0.5)) a.insert(i);
    if (seeded.chance(0.5)) b.insert(i);
  }
  BlockSet both = a;
  both &= b;
  BlockSet only_a = a;
  only_a -= b;
  for (std::size_t i = 0; i < kCount; ++i) {
    EXPECT_EQ(both.contains(i), a.contains(i) && b.contains(i)) << i;
    EXPECT_EQ(only_a.contains(i), a.contains(i) && !b.contains(i)) << i;
  }
  EXPECT_TRUE(a.contains_all(both));
  EXPECT_TRUE(a.contains_all(a));
  EXPECT_TRUE(a.contains_all(BlockSet(kCount)));
  both.clear();
  both.insert(149);
  a -= both;
  EXPECT_FALSE(a.contains_all(both));
}

TEST(BlockSet, TakesTheBlocksOfAWordAtOnce) {
  BlockSet set(130);
  set.insert(1, BlockSet::bit(64) | BlockSet::bit(127));
  set.insert(2, BlockSet::bit(129));
  std::vector<std::size_t> seen;
  set.for_each([&](std::size_t block) { seen.push_back(block); });
  EXPECT_EQ(seen, (std::vector<std::size_t>{64, 127, 129}));
  BlockSet same(130);
  for (const std::size_t block : seen) same.insert(block);
  EXPECT_EQ(set, same);
}

}  // namespace
}  // namespace aucast::face
