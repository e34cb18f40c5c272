#include "common/memory.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace aucast {
namespace {

class GroupMemoryTest : public ::testing::Test {
 protected:
  void write(const std::string& group, const std::string& most, std::uint64_t used,
             std::uint64_t cache) const {
    std::filesystem::create_directories(folder_.path() / group);
    const auto file = [&](const char* name) {
      return (std::filesystem::path(group) / name).string();
    };
    folder_.write(file("memory.max"), most + "\n");
    folder_.write(file("memory.current"), std::to_string(used) + "\n");
    folder_.write(file("memory.stat"),
                  "anon 7\nactive_file 5\ninactive_file " + std::to_string(cache) + "\nslab 9\n");
  }
  [[nodiscard]] std::optional<std::uint64_t> left(const std::string& group) const {
    return left_by_groups(folder_.path(), group);
  }

  test::TempFolder folder_;
};

TEST_F(GroupMemoryTest, CachedFilesAreNotUsed) {
  write("a", "1000", 900, 600);
  EXPECT_EQ(left("a"), 700U);
  write("a", "1000", 1000, 0);
  EXPECT_EQ(left("a"), 0U);
  write("a", "1000", 500, 501);
  EXPECT_EQ(left("a"), 1000U);
  write("a", "1000", 1200, 100);
  EXPECT_EQ(left("a"), 0U) << "the limit was lowered";
}

TEST_F(GroupMemoryTest, TheGroupsAboveCountToo) {
  write("a", "500", 300, 0);
  write("a/b", "max", 200, 0);
  write("a/b/c", "1000", 100, 0);
  EXPECT_EQ(left("a/b/c"), 200U);
  write("", "400", 350, 0);  // as in a container, where the topmost folder is not the system's
  EXPECT_EQ(left("a/b/c"), 50U);
  EXPECT_EQ(left(""), 50U);
  write("a/b/c", "130", 100, 0);
  EXPECT_EQ(left("a/b/c"), 30U);
}

TEST_F(GroupMemoryTest, WithoutALimitNothingIsKnown) {
  write("a", "max", 300, 100);
  EXPECT_EQ(left("a"), std::nullopt);
  EXPECT_EQ(left("no/such"), std::nullopt);
}

TEST(CheckMemory, RefusesWhatWouldLeaveTooLittle) {
  const auto available = available_memory();
  ASSERT_TRUE(available.has_value());
  EXPECT_TRUE(check_memory("a.txt", 0, ""));
  const auto refused = check_memory("a.txt", std::uint64_t{1} << 60U, "buy more");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::Unreadable);
  EXPECT_TRUE(refused.error().message.starts_with("a.txt: too large to hold: it needs "))
      << refused.error().message;
  EXPECT_TRUE(refused.error().message.ends_with("; buy more")) << refused.error().message;
}

}  // namespace
}  // namespace aucast
