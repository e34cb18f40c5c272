#include "server/serve/client_room.h"

#include <limits>

#include <gtest/gtest.h>

#include "protocol/limits.h"
#include "server/settings/limits.h"

namespace aucast::server {
namespace {

constexpr std::uint64_t kGibibyte = std::uint64_t{1} << 30U;

TEST(ClientRoom, WhatIsScarcerIsTheBound) {
  EXPECT_EQ(clients_with_room({kGibibyte, 1'048'576}), 16'384U);
  EXPECT_EQ(clients_with_room({64 * kGibibyte, 65'536}), 65'536U - kDescriptorsKept);
  EXPECT_EQ(clients_with_room({std::nullopt, 1024}), 1024U - kDescriptorsKept);
  EXPECT_EQ(clients_with_room({kGibibyte, std::nullopt}), 16'384U);
}

TEST(ClientRoom, WithFewDescriptorsNoneAreKept) {
  EXPECT_EQ(clients_with_room({kGibibyte, 20}), 20U);
  EXPECT_EQ(clients_with_room({kGibibyte, 2 * kDescriptorsKept}), kDescriptorsKept);
}

TEST(ClientRoom, OneClientIsAlwaysWelcome) {
  EXPECT_EQ(clients_with_room({0, 1024}), 1U);
  EXPECT_EQ(clients_with_room({0, 0}), 1U);
}

TEST(ClientRoom, ThisProcessHasSome) {
  const std::size_t here = clients_with_room(room_now());
  EXPECT_GT(here, 1U);
  EXPECT_LT(here, std::numeric_limits<std::uint64_t>::max()) << "neither is known";
}

}  // namespace
}  // namespace aucast::server
