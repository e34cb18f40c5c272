#include "common/waits.h"

#include <optional>

#include <gtest/gtest.h>

namespace aucast {
namespace {

TEST(Waits, OnlyTheLatestIsWaitedFor) {
  Waits waits;
  const Waits::Token first = waits.begin();
  EXPECT_TRUE(first.current());
  const Waits::Token second = waits.begin();
  EXPECT_FALSE(first.current());
  EXPECT_TRUE(second.current());
  waits.cancel();
  EXPECT_FALSE(second.current());
}

TEST(Waits, NothingIsWaitedForWhenTheOwnerHasGone) {
  std::optional<Waits> waits(std::in_place);
  const Waits::Token token = waits->begin();
  EXPECT_TRUE(token.current());
  waits.reset();
  EXPECT_FALSE(token.current());
}

}  // namespace
}  // namespace aucast
