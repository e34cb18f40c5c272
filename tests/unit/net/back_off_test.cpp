#include "client/net/back_off.h"

#include <gtest/gtest.h>

namespace aucast::net {
namespace {

using namespace std::chrono_literals;

TEST(BackOff, DoublesUpToHalfAMinute) {
  BackOff back_off;
  for (const auto expected : {1s, 2s, 4s, 8s, 16s, 30s, 30s}) {
    EXPECT_EQ(back_off.next(), expected);
  }
}

TEST(BackOff, BeginsAnewAfterASuccess) {
  BackOff back_off;
  EXPECT_EQ(back_off.next(), 1s);
  EXPECT_EQ(back_off.next(), 2s);
  back_off.reset();
  EXPECT_EQ(back_off.next(), 1s);
}

}  // namespace
}  // namespace aucast::net
