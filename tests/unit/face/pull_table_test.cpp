#include "client/face/pull_table.h"

#include <initializer_list>

#include <gtest/gtest.h>

namespace aucast::face {
namespace {

using Table = PullTable<float>;

BlockSet set_of(std::initializer_list<std::size_t> blocks) {
  BlockSet set(4);
  for (const std::size_t block : blocks) set.insert(block);
  return set;
}

/// What `block` is told: muscle numbers and pulls, one after the other.
std::vector<float> told(const Table& table, std::uint32_t block) {
  std::vector<float> result;
  for (const auto& acting : table.acting(block)) {
    result.push_back(static_cast<float>(acting.muscle));
    result.push_back(table.fetch(acting));
  }
  return result;
}

TEST(PullTable, TellsOnlyOfMusclesThatActInTheirOrder) {
  const std::vector<Table::Entry> entries{{2, 0, 0.5F}, {0, 1, 1.5F}, {2, 1, 2.5F}, {2, 3, 3.5F}};
  const BlockSet all = set_of({0, 1, 2, 3});
  Table table(4, entries);
  for (const std::uint32_t block : {0U, 1U, 2U, 3U}) EXPECT_TRUE(told(table, block).empty());
  table.list_acting(std::vector<std::uint32_t>{1, 1, 1, 1}, 1, all);
  EXPECT_EQ(told(table, 0), (std::vector<float>{1, 1.5F}));
  EXPECT_TRUE(told(table, 1).empty());
  EXPECT_EQ(told(table, 2), (std::vector<float>{0, 0.5F, 1, 2.5F, 3, 3.5F}));
  EXPECT_TRUE(told(table, 3).empty());
  table.list_acting(std::vector<std::uint32_t>{0, 1, 0, 0}, 16, all);
  EXPECT_EQ(told(table, 0), (std::vector<float>{16, 1.5F}));
  EXPECT_EQ(told(table, 2), (std::vector<float>{16, 2.5F}));
  table.list_acting(std::vector<std::uint32_t>(4, 0), 1, all);
  for (const std::uint32_t block : {0U, 1U, 2U, 3U}) EXPECT_TRUE(told(table, block).empty());
}

TEST(PullTable, ListsTheBlocksThatAreAskedFor) {
  Table table(4, {{0, 0, 0.5F}, {1, 0, 1.5F}, {3, 0, 2.5F}, {3, 1, 3.5F}});
  const std::vector<std::uint32_t> acts{1, 1};
  table.list_acting(acts, 1, set_of({0, 3}));
  EXPECT_EQ(told(table, 0), (std::vector<float>{0, 0.5F}));
  EXPECT_EQ(told(table, 3), (std::vector<float>{0, 2.5F, 1, 3.5F}));
  table.list_acting(acts, 1, set_of({1, 2}));
  EXPECT_EQ(told(table, 1), (std::vector<float>{0, 1.5F}));
  EXPECT_TRUE(told(table, 2).empty());
}

TEST(PullTable, MayBeEmpty) {
  Table table(3, {});
  table.list_acting(std::vector<std::uint32_t>{1}, 1, set_of({0, 1, 2}));
  for (const std::uint32_t block : {0U, 1U, 2U}) EXPECT_TRUE(told(table, block).empty());
}

}  // namespace
}  // namespace aucast::face
