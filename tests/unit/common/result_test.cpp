#include "common/result.h"

#include <memory>

#include <gtest/gtest.h>

namespace aucast {
namespace {

TEST(Result, HoldsAValue) {
  Result<std::unique_ptr<int>> result(std::make_unique<int>(4));
  ASSERT_TRUE(result.has_value());
  EXPECT_EQ(**result, 4);
  const std::unique_ptr<int> moved = std::move(result).value();
  EXPECT_EQ(*moved, 4);
}

TEST(Result, HoldsAnError) {
  const Result<int> result(Error{ErrorKind::Network, "gone"});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().message, "gone");
  EXPECT_EQ(exit_code(result.error()), 5);
}

TEST(Result, OfNothing) {
  EXPECT_TRUE(Result<void>().has_value());
  EXPECT_EQ(Result<void>(Error{ErrorKind::Usage, "x"}).error().kind, ErrorKind::Usage);
}

TEST(ResultDeathTest, ReadingTheWrongSideAborts) {
  const Result<int> result(Error{ErrorKind::Failed, "x"});
  EXPECT_DEATH(static_cast<void>(result.value()), "broken invariant");
}

}  // namespace
}  // namespace aucast
