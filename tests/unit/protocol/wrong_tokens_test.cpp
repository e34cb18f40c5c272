#include "protocol/wrong_tokens.h"

#include <gtest/gtest.h>

#include "protocol/limits.h"

namespace aucast::protocol {
namespace {

TEST(WrongTokens, OfMoreThanAreKeptTheOldestAreForgotten) {
  WrongTokens wrong;
  const Instant now{};
  for (std::size_t i = 0; i < kWrongTokensMax; ++i) wrong.add(1, now);
  for (std::size_t i = kWrongTokensMax; i < kGuessesMax; ++i) wrong.add(2, now);
  EXPECT_FALSE(wrong.may_try(1, now));
  EXPECT_FALSE(wrong.may_try(2, now));
  wrong.add(3, now);
  EXPECT_TRUE(wrong.may_try(1, now)) << "its first was the oldest";
  EXPECT_FALSE(wrong.may_try(2, now)) << "enough of its own are kept";
  EXPECT_TRUE(wrong.may_try(2, now + kWrongTokensTime));
}

}  // namespace
}  // namespace aucast::protocol
